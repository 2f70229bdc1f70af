// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomChoice.h"

#include "Base/Text.h"
#include "BoneVolume.h"
#include "Readers/TextNumbers.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

namespace bonedecimate::volume
{
namespace
{
using Entries = std::vector<SeriesEntry>;

/// "1: 24 slices in S20, 'Bone 1.0'; 2: ..."
std::string ListOf(const Entries& entries)
{
  constexpr std::size_t most = 30;
  constexpr std::size_t longest = 64; // of the attribute
  std::string text;
  for (std::size_t i = 0; i < std::min(entries.size(), most); ++i)
  {
    const std::string& description = entries[i].Description;
    text += (i > 0 ? "; " : "") + std::to_string(i + 1) + ": " + entries[i].Text +
      (description.empty() ? "" : ", '" + description.substr(0, longest) + "'");
  }
  return entries.size() > most ? text + "; and " + std::to_string(entries.size() - most) + " more"
                               : text;
}

SeriesChoice Impossible(const std::string& problem, const Entries& entries)
{
  SeriesChoice choice;
  choice.Problem = problem + ListOf(entries);
  return choice;
}

/// Indices of the entries for which the predicate is true.
std::vector<std::size_t> Matches(
  const Entries& entries, const std::function<bool(const SeriesEntry&)>& isMatch)
{
  std::vector<std::size_t> matches;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (isMatch(entries[i]))
    {
      matches.push_back(i);
    }
  }
  return matches;
}
}

SeriesChoice ChooseFrom(const Entries& entries, const std::string& choice)
{
  SeriesChoice chosen;
  chosen.IsRequested = true;
  const auto number = ParseWholeNumber(choice);
  if (number && *number >= 1 && *number <= static_cast<std::int64_t>(entries.size()))
  {
    chosen.Index = static_cast<std::size_t>(*number - 1);
    return chosen;
  }
  const std::string text = LowerCase(Trimmed(choice));
  const std::function<bool(const SeriesEntry&)> rules[] = {
    [&](const SeriesEntry& entry) { return entry.Identifier == Trimmed(choice); },
    [&](const SeriesEntry& entry) { return LowerCase(entry.Description) == text; },
    [&](const SeriesEntry& entry)
    { return LowerCase(entry.Description).find(text) != std::string::npos; },
  };
  for (const auto& rule : rules)
  {
    const bool isWhole = &rule != std::end(rules) - 1; // a number that is not there is no part
    const std::vector<std::size_t> matches =
      text.empty() || (number && !isWhole) ? std::vector<std::size_t>() : Matches(entries, rule);
    std::set<std::string> series;
    for (const std::size_t match : matches)
    {
      series.insert(entries[match].Identifier);
    }
    if (series.size() > 1)
    {
      return Impossible("'" + choice + "' is in the description of " +
          std::to_string(series.size()) + " of its series: ",
        entries);
    }
    if (!matches.empty())
    {
      chosen.Index = matches.front();
      return chosen;
    }
  }
  return Impossible(std::string(NoSeriesReason) + "'" + choice + "'; its series are ", entries);
}

SeriesChoice ChooseSeriesOf(const std::vector<DicomSlices>& groups, const Entries& segmentations,
  const std::string& folder, const std::string& choice)
{
  Entries entries;
  for (const DicomSlices& group : groups)
  {
    const DicomSlice& first = group.front();
    entries.push_back({ first.Series, first.Description,
      GroupText(group, folder) + ", " + std::to_string(first.Columns) + " x " +
        std::to_string(first.Rows) + (first.IsTomography ? ", CT" : "") });
  }
  entries.insert(entries.end(), segmentations.begin(), segmentations.end());
  if (!choice.empty() && !entries.empty())
  {
    return ChooseFrom(entries, choice);
  }
  return groups.empty() && segmentations.size() > 1
    ? Impossible("it holds " + std::to_string(segmentations.size()) +
          " DICOM segmentations; give the file of one of them, or --series with its number: ",
        entries)
    : SeriesChoice();
}
}
