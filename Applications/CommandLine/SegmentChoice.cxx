// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentChoice.h"

#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "Options/Text.h"
#include "TotalSegmentator.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <type_traits>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MostSegments = 1000;
constexpr std::size_t MostListed = 30;

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
  for (const Scalar* value = values; value != values + count && labels.size() <= MostSegments + 1;
       ++value)
  {
    const bool isLast = !(*value < last) && !(*value > last); // as of most neighbors
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
  for (std::size_t i = 0; i < std::min(segments.size(), MostListed); ++i)
  {
    text += (i > 0 ? ", " : "") + LabelText(segments[i]);
  }
  return segments.size() > MostListed
    ? text + " and " + std::to_string(segments.size() - MostListed) + " more"
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

/// The words of a choice; a name may have commas itself.
std::vector<std::string> WordsOf(const std::vector<NamedLabel>& segments, const std::string& choice)
{
  const bool isOne = std::any_of(segments.begin(), segments.end(),
    [&](const NamedLabel& segment) { return IsMeant(segment, choice); });
  return isOne ? std::vector<std::string>{ choice } : SplitAt(choice, ',');
}

std::vector<NamedLabel> ChooseBones(
  const std::vector<NamedLabel>& segments, const std::string& path)
{
  std::vector<NamedLabel> chosen;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(chosen),
    [](const NamedLabel& segment) { return TotalSegmentatorBones().count(segment.Value) > 0; });
  if (chosen.empty())
  {
    Reject(path,
      "none of its labels is that of a bone of TotalSegmentator; its segments are " +
        ListOf(segments));
  }
  return chosen;
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

std::vector<NamedLabel> FindSegments(
  vtkImageData* map, const SegmentArguments& arguments, const std::string& path)
{
  std::set<std::int64_t> labels;
  CollectLabels(map, labels);
  return FindSegments(labels, map->GetFieldData(), arguments, path);
}

std::vector<NamedLabel> FindSegments(const std::set<std::int64_t>& labels, vtkFieldData* fields,
  const SegmentArguments& arguments, const std::string& path)
{
  if (labels.empty())
  {
    Reject(path, "none of its voxels has a label: all are 0");
  }
  if (labels.size() > MostSegments)
  {
    Reject(path,
      "it has more than " + std::to_string(MostSegments) +
        " different values, which are no labels; --iso HU takes the surface at a gray value");
  }
  const std::vector<NamedLabel> known = ReadNamedLabels(fields);
  std::vector<NamedLabel> segments;
  for (const std::int64_t label : labels)
  {
    const auto row = std::find_if(
      known.begin(), known.end(), [label](const NamedLabel& one) { return one.Value == label; });
    NamedLabel segment = row == known.end() ? NamedLabel{ label, {}, {} } : *row;
    if (arguments.HasTotalSegmentatorNames)
    {
      const auto bone = TotalSegmentatorBones().find(label);
      segment.Name = bone == TotalSegmentatorBones().end() ? std::string() : bone->second;
    }
    segments.push_back(segment);
  }
  return segments;
}

std::vector<NamedLabel> ChooseSegments(const std::vector<NamedLabel>& segments,
  const SegmentArguments& arguments, const std::string& path)
{
  const std::string word = LowerCase(arguments.Choice);
  if (word == "all")
  {
    return segments;
  }
  if (word == "bones" && arguments.HasTotalSegmentatorNames)
  {
    return ChooseBones(segments, path);
  }
  std::vector<bool> isChosen(segments.size(), false);
  for (const std::string& text : WordsOf(segments, arguments.Choice))
  {
    bool isThere = false;
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const bool isMeant = IsMeant(segments[i], Trimmed(text));
      isChosen[i] = isChosen[i] || isMeant;
      isThere = isThere || isMeant;
    }
    if (!isThere)
    {
      Reject(
        path, "it has no segment '" + Trimmed(text) + "'; its segments are " + ListOf(segments));
    }
  }
  std::vector<NamedLabel> chosen;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (isChosen[i])
    {
      chosen.push_back(segments[i]);
    }
  }
  return chosen;
}
}
