// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Segmentation.h"

#include "Readers/TextNumbers.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <map>
#include <set>

namespace bonedecimate::volume
{
namespace
{
constexpr std::int64_t LargestLabel = 65535;

/// Maps a value of one layer to the index of its segment plus 1.
using SegmentOfValue = std::map<std::int64_t, std::size_t>;

/// @return False if layers or labels are not there or are used twice.
bool FindSegments(const std::vector<Segment>& segments, std::vector<SegmentOfValue>& layers)
{
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment& segment = segments[i];
    const bool isThere = segment.Layer >= 0 &&
      segment.Layer < static_cast<std::int64_t>(layers.size()) && segment.Label != 0;
    if (!isThere ||
      !layers[static_cast<std::size_t>(segment.Layer)].emplace(segment.Label, i + 1).second)
    {
      return false;
    }
  }
  return true;
}

/// Gives labels from 1 on if they repeat or are out of range. @return Whether it did.
bool MakeLabelsDifferent(std::vector<Segment>& segments)
{
  std::set<std::int64_t> labels;
  for (const Segment& segment : segments)
  {
    if (segment.Label > 0 && segment.Label <= LargestLabel)
    {
      labels.insert(segment.Label);
    }
  }
  if (labels.size() == segments.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    segments[i].Label = static_cast<std::int64_t>(i) + 1;
  }
  return true;
}

/// Writes for each voxel the label of its last segment.
template <typename Value>
Overlap Combine(const Value* values, const std::vector<SegmentOfValue>& layers,
  const std::vector<Segment>& segments, const std::vector<bool>& isChosen, unsigned short* labels,
  vtkIdType voxels)
{
  Overlap overlap;
  for (vtkIdType voxel = 0; voxel < voxels; ++voxel)
  {
    std::size_t last = 0;
    int count = 0;
    for (const SegmentOfValue& layer : layers)
    {
      const auto value = static_cast<std::int64_t>(+*values++);
      if (value != 0)
      {
        const auto found = layer.find(value);
        overlap.Undescribed += found == layer.end() ? 1 : 0;
        if (found != layer.end() && isChosen[found->second - 1])
        {
          last = std::max(last, found->second);
          ++count;
        }
      }
    }
    overlap.Voxels += count > 1 ? 1 : 0;
    labels[voxel] = last == 0 ? 0 : static_cast<unsigned short>(segments[last - 1].Label);
  }
  return overlap;
}

std::string LayersNote(const Overlap& overlap, bool isRenumbered, std::size_t segments)
{
  std::string note = OverlapNote(overlap);
  if (isRenumbered)
  {
    note += std::string(note.empty() ? "" : "; ") + "its segments get the labels 1 to " +
      std::to_string(segments) +
      ", because those of the file repeat between its layers or are above 65535";
  }
  return note;
}
}

std::string OverlapNote(const Overlap& overlap)
{
  return overlap.Voxels == 0 ? std::string()
                             : std::to_string(overlap.Voxels) +
      " of its voxels are in more than one segment and count as those of the last one";
}

std::string UndescribedProblem(const Overlap& overlap)
{
  return overlap.Undescribed == 0 ? std::string()
                                  : std::to_string(overlap.Undescribed) +
      " values of its voxels are those of no segment in the header";
}

std::vector<Segment> ReadSegments(const std::function<std::string(const std::string&)>& textOf)
{
  std::vector<Segment> segments;
  for (int i = 0;; ++i)
  {
    const std::string prefix = "Segment" + std::to_string(i) + "_";
    const std::string identifier = textOf(prefix + "ID");
    if (identifier.empty())
    {
      return segments;
    }
    Segment segment;
    segment.Name = textOf(prefix + "Name");
    segment.Name = segment.Name.empty() ? identifier : segment.Name;
    segment.Label = ParseWholeNumber(textOf(prefix + "LabelValue")).value_or(1);
    segment.Layer = ParseWholeNumber(textOf(prefix + "Layer")).value_or(i);
    const auto color = ParseNumbers(textOf(prefix + "Color"));
    if (color && color->size() == 3)
    {
      std::copy(color->begin(), color->end(), segment.Color.begin());
    }
    segments.push_back(segment);
  }
}

std::vector<bool> ChosenSegments(
  const std::vector<Segment>& segments, const SegmentSelection& selection)
{
  std::vector<NamedSegment> all;
  all.reserve(segments.size());
  for (const Segment& segment : segments)
  {
    all.push_back({ segment.Label, segment.Name });
  }
  return selection ? selection(all) : std::vector<bool>(all.size(), true);
}

Volume CombinedLayers(
  const Volume& layers, std::vector<Segment> segments, const SegmentSelection& selection)
{
  vtkDataArray* values = layers.Image->GetPointData()->GetScalars();
  std::vector<SegmentOfValue> ofLayer(static_cast<std::size_t>(values->GetNumberOfComponents()));
  if (values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE)
  {
    return RejectedVolume("the values of its layers are not whole numbers");
  }
  if (!FindSegments(segments, ofLayer))
  {
    return RejectedVolume("the layers or label values of its segments are not those of its voxels");
  }
  const int* size = layers.Image->GetDimensions();
  Volume volume;
  volume.Geometry = layers.Geometry;
  volume.Image = AllocateImage({ { size[0], size[1], size[2] } }, VTK_UNSIGNED_SHORT);
  const bool isRenumbered = MakeLabelsDifferent(segments);
  auto* labels = static_cast<unsigned short*>(volume.Image->GetScalarPointer());
  Overlap overlap;
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      overlap = Combine(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), ofLayer, segments,
        ChosenSegments(segments, selection), labels, values->GetNumberOfTuples()));
    default:
      break;
  }
  if (overlap.Undescribed > 0)
  {
    return RejectedVolume(UndescribedProblem(overlap));
  }
  volume.Note = LayersNote(overlap, isRenumbered, segments.size());
  AddLabelFields(segments, volume.Image->GetFieldData());
  return volume;
}

void AddLabelFields(const std::vector<Segment>& segments, vtkFieldData* fields)
{
  if (segments.empty())
  {
    return;
  }
  vtkNew<vtkTypeInt64Array> values;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkDoubleArray> colors;
  values->SetName("LabelValues");
  names->SetName("LabelNames");
  colors->SetName("LabelColors");
  colors->SetNumberOfComponents(3);
  for (const Segment& segment : segments)
  {
    values->InsertNextValue(segment.Label);
    names->InsertNextValue(segment.Name);
    colors->InsertNextTuple(segment.Color.data());
  }
  fields->AddArray(values);
  fields->AddArray(names);
  fields->AddArray(colors);
}
}
