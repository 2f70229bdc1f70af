// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeSurface.cxx
 * @brief The steps of vtkPBoneDecimate that process 0 does for the whole surface: smoothing, and the comparison of voxels.
 */
#include "BoundaryStrips.h"
#include "Plan.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <limits>
#include <numeric>

namespace
{
/// On process 0, one after the other in the order of the processes; null on the others.
vtkSmartPointer<vtkPolyData> Gathered(vtkPolyData* part, vtkMultiProcessController* controller)
{
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  controller->Gather(part, received, 0);
  if (controller->GetLocalProcessId() != 0)
  {
    return nullptr;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  parts.reserve(received.size());
  for (vtkDataObject* one : received)
  {
    parts.emplace_back(vtkPolyData::SafeDownCast(one));
  }
  return bonedecimate::Join(parts);
}

/// Hands each process its numbers.
/// @param all Of all processes in their order, on process 0 alone.
std::vector<double> Scattered(
  std::vector<double> all, vtkIdType own, vtkMultiProcessController* controller)
{
  const std::size_t processes = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  std::vector<vtkIdType> lengths(processes, 0);
  controller->AllGather(&own, lengths.data(), 1);
  std::vector<vtkIdType> offsets(processes, 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  // One number more, so that there is an address even where there is nothing to receive.
  all.push_back(0.0);
  std::vector<double> received(static_cast<std::size_t>(own) + 1, 0.0);
  controller->ScatterV(all.data(), received.data(), lengths.data(), offsets.data(), own, 0);
  received.pop_back();
  return received;
}
}

//------------------------------------------------------------------------------
void vtkPBoneDecimate::GatherWhole(vtkPolyData* input, Plan& plan)
{
  if (!this->IsTrueAnywhere(plan.Whole != nullptr))
  {
    plan.Whole = Gathered(input, this->Controller);
  }
}

//------------------------------------------------------------------------------
/// Smooths the whole surface as one process would. False if it was rejected.
bool vtkPBoneDecimate::SmoothTogether(vtkPolyData* input, Plan& plan)
{
  const bool smooths = this->GetSmoothing() > 0.0 || this->GetAutomaticSmoothing();
  if (!smooths || plan.Total == 0.0)
  {
    return true;
  }
  this->GatherWhole(input, plan);
  std::vector<double> points;
  if (plan.Whole)
  {
    // More would be beyond the largest error of phase 1.
    const double most =
      plan.Error > 0.0 ? plan.ErrorOfParts() : std::numeric_limits<double>::infinity();
    points = this->SmoothPoints(plan.Whole, most);
  }
  const bool isDone = this->IsTrueAnywhere(!points.empty());
  if (!isDone)
  {
    if (!plan.Whole)
    {
      vtkErrorMacro(<< "process 0 rejected the whole surface");
    }
    return false;
  }
  plan.SmoothedPoints =
    Scattered(std::move(points), 3 * input->GetNumberOfPoints(), this->Controller);
  plan.Shared.clear();
  for (std::size_t i = 0; i < plan.IsShared.size(); ++i)
  {
    if (plan.IsShared[i] != 0)
    {
      plan.Shared.push_back(bonedecimate::PositionOf(plan.SmoothedPoints.data() + 3 * i));
    }
  }
  bonedecimate::SortOnce(plan.Shared);
  return true;
}

//------------------------------------------------------------------------------
/// The figures are then those of every process.
void vtkPBoneDecimate::CompareVoxelsTogether(vtkPolyData* input, vtkPolyData* output, Plan& plan)
{
  if (plan.VoxelSize > 0.0)
  {
    this->GatherWhole(input, plan);
    const vtkSmartPointer<vtkPolyData> result = Gathered(output, this->Controller);
    if (result)
    {
      this->CompareVoxels(plan.Whole, result, plan.GuardsVoxels);
    }
  }
  std::vector<char> figures = this->FiguresOfSegmentation();
  vtkIdType length = static_cast<vtkIdType>(figures.size());
  this->Controller->Broadcast(&length, 1, 0);
  figures.resize(static_cast<std::size_t>(length));
  this->Controller->Broadcast(figures.data(), length, 0);
  this->TakeFiguresOfSegmentation(figures);
}
