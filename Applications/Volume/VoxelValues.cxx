// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelValues.h"

#include "LabelFields.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cstddef>

namespace bonedecimate::volume
{
namespace
{
constexpr int LargestLabel = 65535;
constexpr std::size_t MostLabels = 1024;

/// Pairs of neighbors that have the label on one side and no 0 on the other.
struct Pairs
{
  std::int64_t Equal = 0;
  std::int64_t Different = 0;

  bool AreMostlyEqual() const { return this->Equal >= this->Different; }
};

template <typename Value>
class Survey
{
public:
  Survey(const Value* values, vtkImageData* image)
    : Values(values)
    , Count(image->GetNumberOfPoints())
  {
    vtkIdType step = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] = image->GetDimensions()[axis];
      this->Steps[axis] = step;
      step *= this->Size[axis];
    }
  }

  /// Empty if there are other values than labels, or too many.
  std::vector<int> FindLabels()
  {
    std::vector<bool> isThere(LargestLabel + 1, false);
    std::size_t found = 0;
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      if (!IsLabel(this->Values[i]))
      {
        return {};
      }
      const std::size_t label = IndexOf(this->Values[i]);
      if (!isThere[label])
      {
        isThere[label] = true;
        found += label > 0 ? 1 : 0;
      }
      if (found > MostLabels)
      {
        return {};
      }
    }
    std::vector<int> labels;
    for (int label = 1; label <= LargestLabel; ++label)
    {
      if (isThere[static_cast<std::size_t>(label)])
      {
        labels.push_back(label);
      }
    }
    return labels;
  }

  /// Whether the voxels of most labels lie together.
  bool HasRegions(const std::vector<int>& labels)
  {
    std::vector<Pairs> pairs(LargestLabel + 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->CountPairs(axis, pairs);
    }
    Pairs all;
    std::size_t together = 0;
    for (const int label : labels)
    {
      const Pairs& own = pairs[static_cast<std::size_t>(label)];
      all.Equal += own.Equal;
      all.Different += own.Different;
      together += own.AreMostlyEqual() ? 1 : 0;
    }
    return all.AreMostlyEqual() && 2 * together >= labels.size();
  }

private:
  static bool IsLabel(Value value)
  {
    const auto number = static_cast<double>(value);
    return number >= 0.0 && number <= LargestLabel &&
      number == static_cast<double>(static_cast<int>(number));
  }

  /// Of a label.
  static std::size_t IndexOf(Value value)
  {
    return static_cast<std::size_t>(static_cast<int>(value));
  }

  void CountPairs(std::size_t axis, std::vector<Pairs>& pairs) const
  {
    const vtkIdType step = this->Steps[axis];
    for (vtkIdType i = 0; i + step < this->Count; ++i)
    {
      if (i / step % this->Size[axis] + 1 == this->Size[axis])
      {
        continue; // the last along the axis: the next voxel in memory is no neighbor
      }
      const std::size_t a = IndexOf(this->Values[i]);
      const std::size_t b = IndexOf(this->Values[i + step]);
      if (a > 0 && a == b)
      {
        ++pairs[a].Equal;
      }
      else if (a > 0 && b > 0)
      {
        ++pairs[a].Different;
        ++pairs[b].Different;
      }
    }
  }

  const Value* Values;
  vtkIdType Count;
  std::array<vtkIdType, 3> Size{};
  std::array<vtkIdType, 3> Steps{};
};

template <typename Value>
ValueSurvey SurveyAs(const Value* values, const Volume& volume)
{
  Survey<Value> survey(values, volume.Image);
  ValueSurvey result;
  result.Labels = survey.FindLabels();
  if (result.Labels.size() == 1)
  {
    result.Kind = ValueKind::Mask;
  }
  else if (!result.Labels.empty() &&
    (HasLabelFields(volume.Image) || survey.HasRegions(result.Labels)))
  {
    result.Kind = ValueKind::Labels;
  }
  return result;
}
}

ValueSurvey SurveyValues(const Volume& volume)
{
  vtkDataArray* values = volume.Image->GetPointData()->GetScalars();
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      return SurveyAs(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), volume));
    default:
      return {};
  }
}
}
