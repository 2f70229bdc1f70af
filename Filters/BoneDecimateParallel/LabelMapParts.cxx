// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapParts.h"

#include "WholeInput.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace bonedecimate
{
namespace
{
/// The least and the largest values of parts; equal if the parts are.
class Range
{
public:
  void Add(const std::vector<double>& values)
  {
    if (this->Low.empty())
    {
      this->Low = values;
      this->High = values;
    }
    this->HasOneSize = this->HasOneSize && values.size() == this->Low.size();
    for (std::size_t i = 0; i < std::min(values.size(), this->Low.size()); ++i)
    {
      this->Low[i] = std::min(this->Low[i], values[i]);
      this->High[i] = std::max(this->High[i], values[i]);
    }
  }

  /// Reduces the ranges over all processes.
  void Reduce(vtkMultiProcessController* controller)
  {
    const bool isEmpty = this->Low.empty();
    constexpr double none = std::numeric_limits<double>::infinity();
    const double size = static_cast<double>(this->Low.size());
    double sizes[3] = { isEmpty ? none : size, isEmpty ? none : -size,
      this->HasOneSize ? 1.0 : 0.0 };
    double least[3];
    controller->AllReduce(sizes, least, 3, vtkCommunicator::MIN_OP);
    this->HasOneSize = least[2] > 0.0 && (least[0] == -least[1] || least[0] == none);
    if (this->HasOneSize && least[0] < none)
    {
      this->Low.resize(static_cast<std::size_t>(least[0]), none);
      this->High.resize(this->Low.size(), -none);
      const std::vector<double> low = this->Low;
      const std::vector<double> high = this->High;
      const auto count = static_cast<vtkIdType>(low.size());
      controller->AllReduce(low.data(), this->Low.data(), count, vtkCommunicator::MIN_OP);
      controller->AllReduce(high.data(), this->High.data(), count, vtkCommunicator::MAX_OP);
    }
  }

  bool IsOne() const { return this->HasOneSize && this->Low == this->High; }
  const std::vector<double>& Values() const { return this->Low; }

private:
  bool HasOneSize = true;
  std::vector<double> Low;
  std::vector<double> High;
};

/// Which arrays there are, the smallest spacing or 0, and the values of those that describe the
/// grid and the labels.
std::vector<double> DescriptionOf(vtkPolyData* surface)
{
  std::vector<double> values = { 0.0,
    static_cast<double>(surface->GetCellData()->HasArray("BoundaryLabels")),
    static_cast<double>(surface->GetPointData()->HasArray("GridPoint")) };
  for (const char* name : { "VoxelGridSpacing", "VoxelGridOrigin", "VoxelGridDirection",
         "VoxelGridDimensions", "VoxelGridLayers", "LabelValues" })
  {
    vtkDataArray* array = surface->GetFieldData()->GetArray(name);
    const vtkIdType count = array ? array->GetNumberOfValues() : 0;
    values.push_back(static_cast<double>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const int components = array->GetNumberOfComponents();
      values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
    }
  }
  constexpr std::size_t spacing = 4;
  values[0] = values[spacing - 1] == 3.0
    ? std::min({ values[spacing], values[spacing + 1], values[spacing + 2] })
    : 0.0;
  return values;
}
}

//------------------------------------------------------------------------------
LabelMapOfParts CompareLabelMaps(vtkDataObject* input, vtkMultiProcessController* controller)
{
  Range range;
  for (vtkPolyData* part : FilledParts(input))
  {
    range.Add(DescriptionOf(part));
  }
  if (controller)
  {
    range.Reduce(controller);
  }
  return { range.IsOne(), range.Values().empty() ? 0.0 : range.Values().front() };
}
}
