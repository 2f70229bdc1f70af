// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeSurface.cxx
 * @brief The steps of vtkPBoneDecimate that process 0 does for the whole surface: smoothing, and
 * the comparison of voxels.
 */
#include "Gathering.h"
#include "Plan.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <numeric>

namespace
{
/// Hands each process its numbers.
/// @param all Values of all processes in their order, on process 0 alone.
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
    plan.Whole = bonedecimate::GatheredAt(0, input, this->Controller);
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
    points = this->Internal->SmoothPoints(plan.Whole);
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
void vtkPBoneDecimate::CompareVoxelsTogether(vtkPolyData* output, Plan& plan)
{
  if (plan.VoxelSize > 0.0)
  {
    if (this->Internal->Prunes())
    {
      plan.Whole = nullptr; // as on one process, what was pruned counts
    }
    this->GatherWhole(plan.Unpruned, plan);
    const vtkSmartPointer<vtkPolyData> result =
      bonedecimate::GatheredAt(0, output, this->Controller);
    if (result)
    {
      this->Internal->CompareVoxels(plan.Whole, result, plan.GuardsVoxels);
    }
  }
  std::vector<char> figures = this->Internal->FiguresOfSegmentation();
  vtkIdType length = static_cast<vtkIdType>(figures.size());
  this->Controller->Broadcast(&length, 1, 0);
  figures.resize(static_cast<std::size_t>(length));
  this->Controller->Broadcast(figures.data(), length, 0);
  this->Internal->TakeFiguresOfSegmentation(figures);
}
