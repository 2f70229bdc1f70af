// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelValues.h"

#include "LabelMaps/LabelFields.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace bonedecimate::volume
{
namespace
{
constexpr int LargestLabel = 65535;
constexpr std::size_t MostLabels = 1024;

template <typename Value>
bool IsLabel(Value value)
{
  const auto number = static_cast<double>(value);
  return number >= 0.0 && number <= LargestLabel &&
    number == static_cast<double>(static_cast<int>(number));
}

/// Index of a label.
template <typename Value>
std::size_t IndexOf(Value value)
{
  return static_cast<std::size_t>(static_cast<int>(value));
}
}

void ValueSurvey::Add(const Volume& slab)
{
  vtkDataArray* const values = slab.Image->GetPointData()->GetScalars();
  const int* const size = slab.Image->GetDimensions();
  const std::array<vtkIdType, 3> count{ { size[0], size[1], size[2] } };
  const bool hasSharedLayer = slab.Image->GetExtent()[4] > 0;
  this->IsSegmentation = this->IsSegmentation || HasLabelFields(slab.Image);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(this->AddValues(
      static_cast<const VTK_TT*>(values->GetVoidPointer(0)), count, hasSharedLayer));
    default:
      this->MayBeLabels = false;
  }
}

template <typename Value>
void ValueSurvey::AddValues(
  const Value* values, const std::array<vtkIdType, 3>& size, bool hasSharedLayer)
{
  const vtkIdType layer = size[0] * size[1];
  const Value* const end = values + layer * size[2];
  const Value* const begin = values + (hasSharedLayer ? layer : 0);
  this->FindRange(begin, end);
  this->FindLabels(begin, end);
  for (const Value* row = values; this->MayBeLabels && row != end; row += size[0])
  {
    if (row >= begin)
    {
      this->CountPairs(row, row + 1, size[0] - 1);
      const bool isLastOfLayer = (row - values) % layer + size[0] == layer;
      this->CountPairs(row, row + size[0], isLastOfLayer ? 0 : size[0]);
    }
    this->CountPairs(row, row + layer, end - row > layer ? size[0] : 0);
  }
}

template <typename Value>
void ValueSurvey::FindRange(const Value* begin, const Value* end)
{
  Value least = std::numeric_limits<Value>::max();
  Value largest = std::numeric_limits<Value>::lowest();
  for (const Value* value = begin; value != end; ++value)
  {
    if constexpr (std::is_floating_point_v<Value>)
    {
      if (!std::isfinite(*value))
      {
        ++this->NotFinite;
        continue;
      }
    }
    least = *value < least ? *value : least;
    largest = *value > largest ? *value : largest;
  }
  this->Least = std::min(this->Least, static_cast<double>(least));
  this->Largest = std::max(this->Largest, static_cast<double>(largest));
}

template <typename Value>
void ValueSurvey::FindLabels(const Value* begin, const Value* end)
{
  this->Occurs.resize(LargestLabel + 1);
  this->OfLabel.resize(LargestLabel + 1);
  for (const Value* value = begin; this->MayBeLabels && value != end; ++value)
  {
    if (value != begin && *value == *(value - 1))
    {
      continue;
    }
    this->MayBeLabels = IsLabel(*value);
    if (this->MayBeLabels && !this->Occurs[IndexOf(*value)])
    {
      this->Occurs[IndexOf(*value)] = true;
      this->Found += IndexOf(*value) > 0 ? 1 : 0;
      this->MayBeLabels = this->Found <= MostLabels;
    }
  }
}

template <typename Value>
void ValueSurvey::CountPairs(const Value* row, const Value* neighbors, vtkIdType count)
{
  for (vtkIdType x = 0; x < count; ++x)
  {
    const std::size_t a = IndexOf(row[x]);
    const std::size_t b = IndexOf(neighbors[x]);
    if (a == 0 || b == 0)
    {
      continue;
    }
    if (a == b)
    {
      ++this->OfLabel[a].Equal;
    }
    else
    {
      ++this->OfLabel[a].Different;
      ++this->OfLabel[b].Different;
    }
  }
}

std::vector<int> ValueSurvey::GetLabels() const
{
  std::vector<int> labels;
  for (int label = 1; this->MayBeLabels && label <= LargestLabel; ++label)
  {
    if (this->Occurs[static_cast<std::size_t>(label)])
    {
      labels.push_back(label);
    }
  }
  return labels;
}

/// Whether the voxels of most labels lie together.
bool ValueSurvey::HasRegions() const
{
  Pairs all;
  std::size_t together = 0;
  for (const int label : this->GetLabels())
  {
    const Pairs& own = this->OfLabel[static_cast<std::size_t>(label)];
    all.Equal += own.Equal;
    all.Different += own.Different;
    together += own.AreMostlyEqual() ? 1 : 0;
  }
  return all.AreMostlyEqual() && 2 * together >= this->Found;
}

ValueKind ValueSurvey::GetKind() const
{
  if (!this->MayBeLabels || this->Found == 0)
  {
    return ValueKind::Intensities;
  }
  if (this->Found == 1)
  {
    return ValueKind::Mask;
  }
  return this->IsSegmentation || this->HasRegions() ? ValueKind::Labels : ValueKind::Intensities;
}
}
