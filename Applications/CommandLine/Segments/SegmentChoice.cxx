// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentChoice.h"

#include "Base/Text.h"
#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Labels/LabelNames.h"
#include "Labels/LabelTableSearch.h"
#include "Labels/SegmentPresets.h"
#include "PlainText.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxListed = 30;

/// Whether the value is a whole number, which all others are for vtkBoneSurfaces to reject.
template <typename Scalar>
bool IsLabel(Scalar value)
{
  if constexpr (std::is_floating_point_v<Scalar>)
  {
    constexpr double largest = 9007199254740992.0;
    const double number = value;
    return std::abs(number) <= largest && !(std::floor(number) < number);
  }
  else
  {
    return true;
  }
}

/// All values but 0, or more than the most segments.
template <typename Scalar>
void CollectValues(const Scalar* values, vtkIdType count, std::set<std::int64_t>& labels)
{
  Scalar last = 0;
  for (const Scalar* value = values; value != values + count && labels.size() <= MaxLabels + 1;
       ++value)
  {
    const bool isLast = !(*value < last) && !(*value > last); // true for most neighbors
    if (!isLast && IsLabel(*value))
    {
      last = *value;
      labels.insert(static_cast<std::int64_t>(last));
    }
  }
  labels.erase(0);
}

/// "1 (femur), 2 (tibia), 5"
std::string ListOf(const std::vector<NamedLabel>& segments)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(segments.size(), MaxListed); ++i)
  {
    text += (i > 0 ? ", " : "") + LabelText(segments[i]);
  }
  return segments.size() > MaxListed
    ? text + " and " + std::to_string(segments.size() - MaxListed) + " more"
    : text;
}

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool IsMeant(const NamedLabel& segment, const std::string& word)
{
  return std::to_string(segment.Value) == word ||
    (!segment.Name.empty() && LowerCase(segment.Name) == LowerCase(word));
}

/// Whether the word names a region of nnU-Net, which has several labels, with this segment.
bool IsInRegion(const NamedLabel& segment, const std::string& word, const LabelRegions& regions)
{
  const auto region = regions.find(LowerCase(word));
  return region != regions.end() &&
    std::find(region->second.begin(), region->second.end(), segment.Value) != region->second.end();
}

/// The words of a choice; a name may have commas itself.
std::vector<std::string> WordsOf(const std::vector<NamedLabel>& segments, const std::string& choice)
{
  const bool isOne = std::any_of(segments.begin(), segments.end(),
    [&](const NamedLabel& segment) { return IsMeant(segment, choice); });
  return isOne ? std::vector<std::string>{ choice } : SplitAt(choice, ',');
}

void WarnOfEmpty(
  const std::vector<NamedLabel>& empty, bool areSegments, std::vector<std::string>& warnings)
{
  if (!empty.empty())
  {
    warnings.push_back("no surface of " + ListOf(empty) + ": no voxel has " +
      (empty.size() == 1 ? "this label" : "one of these labels") +
      (areSegments
          ? ", because a segment is empty or others cover it; a segment that is chosen alone is "
            "not covered"
          : ""));
  }
}

/// Whether a word of the choice chooses the segment.
bool IsChosenBy(
  const NamedLabel& segment, const std::string& word, bool meansPreset, const LabelRegions& regions)
{
  return IsMeant(segment, word) || IsInRegion(segment, word, regions) ||
    (meansPreset && IsOfPreset(word, segment.Name));
}

/// Whether the word means a preset, which a segment of this name comes before.
bool MeansPreset(const std::string& word, const std::vector<NamedLabel>& segments)
{
  return IsPreset(word) &&
    std::none_of(segments.begin(), segments.end(),
      [&word](const NamedLabel& segment) { return IsMeant(segment, word); });
}
}

void CollectLabels(vtkImageData* map, std::set<std::int64_t>& labels)
{
  vtkDataArray* const array = map->GetPointData()->GetScalars();
  switch (array ? array->GetDataType() : int(VTK_VOID))
  {
    vtkTemplateMacro(CollectValues(
      static_cast<const VTK_TT*>(array->GetVoidPointer(0)), array->GetNumberOfTuples(), labels));
    default:
      break;
  }
}

FoundSegments FindSegments(
  vtkImageData* map, const SegmentArguments& arguments, const std::string& path)
{
  std::set<std::int64_t> labels;
  CollectLabels(map, labels);
  return FindSegments(labels, map->GetFieldData(), arguments, path);
}

FoundSegments FindSegments(const std::set<std::int64_t>& labels, vtkFieldData* fields,
  const SegmentArguments& arguments, const std::string& path)
{
  if (labels.size() > MaxLabels)
  {
    Reject(path,
      "it has more than " + std::to_string(MaxLabels) +
        " different values, which are no labels; --iso HU takes the surface at a gray value");
  }
  LabelNames names = FindLabelNames(path, fields, arguments);
  FoundSegments segments;
  for (const std::int64_t label : labels)
  {
    const NamedLabel* const named = names.Find(label);
    segments.Present.push_back(named ? *named : NamedLabel{ label, {}, {} });
  }
  const std::vector<NamedLabel>& known = names.Table.Labels;
  std::copy_if(known.begin(), known.end(), std::back_inserter(segments.Empty),
    [&labels](const NamedLabel& one) { return one.Value != 0 && labels.count(one.Value) == 0; });
  segments.Regions = std::move(names.Table.Regions);
  segments.AreDescribed = names.AreSegments;
  segments.Note = names.Note;
  segments.Warnings = names.Warnings;
  if (labels.empty() && (segments.Empty.empty() || LowerCase(arguments.Choice) == "all"))
  {
    Reject(path, std::string(NoLabelReason) + ": all are 0");
  }
  return segments;
}

std::vector<NamedLabel> ChooseSegments(const FoundSegments& segments,
  const SegmentArguments& arguments, const std::string& path, std::vector<std::string>& warnings)
{
  const std::string word = LowerCase(arguments.Choice);
  warnings.insert(warnings.end(), segments.Warnings.begin(), segments.Warnings.end());
  if (word == "all")
  {
    // A table names what a map may have.
    WarnOfEmpty(segments.AreDescribed ? segments.Empty : std::vector<NamedLabel>(), true, warnings);
    return segments.Present;
  }
  std::vector<NamedLabel> all = segments.Present;
  all.insert(all.end(), segments.Empty.begin(), segments.Empty.end());
  std::vector<bool> isChosen(all.size(), false);
  for (const std::string& text : WordsOf(all, arguments.Choice))
  {
    bool isThere = false;
    const bool meansPreset = MeansPreset(Trimmed(text), all);
    // A table of what maps may have has all bones.
    const bool isOfPresent = meansPreset && !segments.AreDescribed;
    for (std::size_t i = 0; i < (isOfPresent ? segments.Present : all).size(); ++i)
    {
      const bool isMeant = IsChosenBy(all[i], Trimmed(text), meansPreset, segments.Regions);
      isChosen[i] = isChosen[i] || isMeant;
      isThere = isThere || isMeant;
    }
    if (!isThere)
    {
      Reject(path,
        (meansPreset ? "the name of none of its segments is one that '" : "it has no segment '") +
          Trimmed(text) + (meansPreset ? "' means" : "'") + "; its segments are " +
          ListOf(segments.AreDescribed ? all : segments.Present));
    }
  }
  std::vector<NamedLabel> chosen;
  std::vector<NamedLabel> empty;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (isChosen[i])
    {
      (i < segments.Present.size() ? chosen : empty).push_back(all[i]);
    }
  }
  if (chosen.empty())
  {
    Reject(path, NoChosenVoxelReason + ListOf(empty));
  }
  WarnOfEmpty(empty, segments.AreDescribed, warnings);
  return chosen;
}

//------------------------------------------------------------------------------
std::vector<LeftOut> SegmentsLeftOut(const FoundSegments& segments,
  const SegmentArguments& arguments, const std::vector<NamedLabel>& chosen)
{
  if (LowerCase(arguments.Choice) == "all")
  {
    return {};
  }
  std::vector<NamedLabel> others = segments.Present;
  if (segments.AreDescribed) // those that were not chosen have not been read
  {
    others.insert(others.end(), segments.Empty.begin(), segments.Empty.end());
  }
  const auto isChosen = [&chosen](const NamedLabel& segment)
  {
    return std::any_of(chosen.begin(), chosen.end(),
      [&segment](const NamedLabel& one) { return one.Value == segment.Value; });
  };
  others.erase(std::remove_if(others.begin(), others.end(), isChosen), others.end());
  std::vector<LeftOut> leftOut;
  if (!others.empty())
  {
    leftOut.push_back({ "segments", static_cast<std::int64_t>(others.size()),
      others.size() == 1 ? "segment that was not chosen" : "segments that were not chosen",
      LabelText(others.front()) });
  }
  return leftOut;
}

//------------------------------------------------------------------------------
SegmentSelection SelectionOf(const SegmentArguments& arguments, const std::string& path)
{
  const std::string word = LowerCase(arguments.Choice);
  if (word.empty() || word == "all")
  {
    return {};
  }
  const LabelTable table =
    arguments.LabelNames.empty() ? FindTableBeside(path).Table : TableOfArguments(arguments);
  return [arguments, table](const std::vector<NamedSegment>& all)
  {
    std::vector<NamedLabel> segments;
    segments.reserve(all.size());
    for (const NamedSegment& one : all)
    {
      segments.push_back({ one.Label, NameOfSegment(one.Label, PlainText(one.Name), table), {} });
    }
    std::vector<bool> areChosen(all.size(), false);
    for (const std::string& text : WordsOf(segments, arguments.Choice))
    {
      const bool meansPreset = MeansPreset(Trimmed(text), segments);
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        areChosen[i] =
          areChosen[i] || IsChosenBy(segments[i], Trimmed(text), meansPreset, table.Regions);
      }
    }
    return areChosen;
  };
}
}
