// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Strips.cxx
 * @brief What vtkPBoneDecimate does where parts are near each other: what phase 1 keeps away from,
 * and phase 2.
 */
#include "BoundaryStrips.h"
#include "Gathering.h"
#include "Plan.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace
{
vtkDataArray* PointValues(vtkPolyData* surface, const std::string& name)
{
  return surface->GetPointData()->GetArray(name.c_str());
}

/// For each point of the result the sum of the counts of the points that became part of it.
void SumCounts(
  vtkPolyData* before, vtkDataArray* became, vtkPolyData* after, const std::string& name)
{
  vtkDataArray* from = PointValues(before, name);
  vtkDataArray* to = PointValues(after, name);
  if (from && to && became)
  {
    to->Fill(0.0);
    for (vtkIdType i = 0; i < became->GetNumberOfTuples(); ++i)
    {
      const vtkIdType point = static_cast<vtkIdType>(became->GetComponent(i, 0));
      if (point >= 0)
      {
        to->SetComponent(point, 0, to->GetComponent(point, 0) + from->GetComponent(i, 0));
      }
    }
  }
}

/// Points that were there before may have unchanged triangles around them.
void KeepBounds(vtkPolyData* before, vtkPolyData* after, const std::string& name)
{
  vtkDataArray* from = PointValues(before, name);
  vtkDataArray* to = PointValues(after, name);
  if (!from || !to)
  {
    return;
  }
  std::map<bonedecimate::Position, double> known;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    double& bound = known[bonedecimate::PositionOf(before->GetPoint(i))];
    bound = std::fmax(bound, from->GetComponent(i, 0));
  }
  for (vtkIdType i = 0; i < after->GetNumberOfPoints(); ++i)
  {
    const auto found = known.find(bonedecimate::PositionOf(after->GetPoint(i)));
    if (found != known.end())
    {
      to->SetComponent(i, 0, std::fmax(to->GetComponent(i, 0), found->second));
    }
  }
}

/// mm, of all processes: low and high along each axis; a box without points has no side.
std::vector<double> AllBounds(vtkPolyData* surface, vtkMultiProcessController* controller)
{
  double own[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (surface->GetNumberOfPoints() > 0)
  {
    surface->GetBounds(own);
  }
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(own, all.data(), 6);
  return all;
}

/// For each cell, whether its bounding box is within the distance of the box.
std::vector<bool> CellsNearBox(vtkPolyData* surface, vtkBoundingBox box, double distance)
{
  std::vector<bool> are(static_cast<std::size_t>(surface->GetNumberOfCells()), false);
  if (box.IsValid())
  {
    box.Inflate(distance);
    double bounds[6];
    for (std::size_t cell = 0; cell < are.size(); ++cell)
    {
      surface->GetCellBounds(static_cast<vtkIdType>(cell), bounds);
      are[cell] = box.Intersects(vtkBoundingBox(bounds)) != 0;
    }
  }
  return are;
}
}

//------------------------------------------------------------------------------
/// What phase 1 has to know of the input of other processes.
void vtkPBoneDecimate::FindNeighbors(vtkPolyData* input, Plan& plan)
{
  plan.Neighbors = vtkSmartPointer<vtkPolyData>::New();
  if (!plan.ProvesError)
  {
    return;
  }
  // What phase 1 makes is within one largest error of this process's input.
  const double reach = plan.NeighborDistance() + Plan::OneError * plan.Error;
  const vtkSmartPointer<vtkPolyData> bare = bonedecimate::WithoutArrays(input);
  const std::vector<double> bounds = AllBounds(bare, this->Controller);
  const int own = this->Controller->GetLocalProcessId();
  for (int process = 0; process < this->Controller->GetNumberOfProcesses(); ++process)
  {
    const vtkBoundingBox box(bounds.data() + 6 * static_cast<std::size_t>(process));
    const vtkSmartPointer<vtkPolyData> piece = process == own
      ? vtkSmartPointer<vtkPolyData>::New()
      : bonedecimate::OnlyCells(bare, CellsNearBox(bare, box, reach));
    const vtkSmartPointer<vtkPolyData> near =
      bonedecimate::GatheredAt(process, piece, this->Controller);
    if (near)
    {
      plan.Neighbors = bonedecimate::OnlyCells(near, this->Internal->CellsNear(near, bare, reach));
    }
  }
}

//------------------------------------------------------------------------------
/// For each cell of the input or of the result of phase 1, whether phase 1 leaves it unchanged.
std::vector<bool> vtkPBoneDecimate::UnchangedCells(vtkPolyData* surface, const Plan& plan) const
{
  std::vector<bool> cells = bonedecimate::CellsAt(surface, plan.Shared);
  if (plan.ProvesError)
  {
    const std::vector<bool> near =
      this->Internal->CellsNear(surface, plan.Neighbors, plan.NeighborDistance());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      cells[i] = cells[i] || near[i];
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
/// What phase 2 changes, and around it what it has to see.
vtkPBoneDecimate::Strips vtkPBoneDecimate::CutStripsOfAll(
  vtkPolyData* input, vtkPolyData* output, const Plan& plan)
{
  Strips strips;
  const std::vector<bool> mayChange =
    bonedecimate::RingsAround(output, this->UnchangedCells(output, plan));
  std::vector<bool> around(mayChange.size(), false);
  if (plan.ProvesError)
  {
    const double error = Plan::OneError * plan.Error;
    const vtkSmartPointer<vtkPolyData> bare = bonedecimate::WithoutArrays(
      bonedecimate::WithoutCells(input, this->Internal->CellsWithoutArea(input)));
    const auto changing = bonedecimate::GatheredEverywhere(
      bonedecimate::WithoutArrays(bonedecimate::OnlyCells(output, mayChange)), this->Controller);
    strips.Original = bonedecimate::GatheredEverywhere(
      bonedecimate::CutOut(bare, this->Internal->CellsNear(bare, changing, error)),
      this->Controller);
    around = this->Internal->CellsNear(output, strips.Original, Plan::ErrorsOfReach * plan.Error);
  }
  const bonedecimate::StripParts parts = bonedecimate::CutStrips(output, mayChange, around);
  strips.Rest = parts.Rest;
  strips.Own = parts.Strip;
  return strips;
}

//------------------------------------------------------------------------------
/// Phase 2: process 0 gets the result of the strips of all processes.
void vtkPBoneDecimate::ReduceSharedStrips(
  vtkPolyData* input, Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy)
{
  Strips strips = this->CutStripsOfAll(input, output, plan);
  const double rest = static_cast<double>(strips.Rest->GetNumberOfPolys());
  const double own = static_cast<double>(strips.Own->GetNumberOfPolys());
  plan.StripsBefore = this->OfAll(own, vtkCommunicator::SUM_OP);
  const double left = plan.Target - this->OfAll(rest, vtkCommunicator::SUM_OP);
  vtkSmartPointer<vtkPolyData> reduced = bonedecimate::GatheredAt(0, strips.Own, this->Controller);
  const bool isFirst = reduced != nullptr;
  reduced = isFirst ? reduced : vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPBoneDecimate> run;
  if (reduced->GetNumberOfPolys() > 0)
  {
    const double triangles = plan.Target > 0.0 ? std::max(left, 1.0) : 0.0;
    reduced = this->ReduceStrips(run, reduced, strips, plan, triangles);
  }
  this->Controller->Broadcast(reduced, 0);
  plan.StripsAfter = static_cast<double>(reduced->GetNumberOfPolys());
  this->AddRuns(run, plan);
  this->MeasureAnew(input, strips.Rest, reduced);
  this->FillInputCopy(plan.Unpruned, { strips.Rest, reduced }, inputCopy);
  const auto whole = isFirst ? bonedecimate::Join({ strips.Rest, reduced }) : strips.Rest;
  whole->GetFieldData()->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(whole);
}

//------------------------------------------------------------------------------
/// The strips as they were if they are rejected or not proved.
vtkSmartPointer<vtkPolyData> vtkPBoneDecimate::ReduceStrips(vtkPBoneDecimate* run,
  vtkPolyData* joined, const Strips& strips, const Plan& plan, double triangles)
{
  this->Order(run, triangles, plan);
  run->Internal->SetPart(bonedecimate::TakeRim(joined), {});
  const Internals::EdgesOfPart cuts = bonedecimate::TakeCuts(joined);
  if (plan.ProvesError)
  {
    const Internals::EdgesOfPart originalCuts = bonedecimate::TakeCuts(strips.Original);
    run->Internal->SetOriginalOfPart(strips.Original, cuts, originalCuts);
  }
  run->SetMergePoints(true); // that is what joins them
  run->SetMakeMaps(true);
  run->SetMeasureDistances(false);
  run->SetMeasureInputDistances(false);
  const bool isDone = this->Run(run, joined, nullptr);
  if (!isDone || run->GetProvedError() > plan.Error)
  {
    run->Internal->TakeReport(*vtkSmartPointer<vtkPBoneDecimate>::New());
    return joined;
  }
  vtkPolyData* reduced = run->GetOutput();
  vtkPolyData* copy = vtkPolyData::SafeDownCast(run->GetOutputDataObject(1));
  SumCounts(joined, PointValues(copy, "ResultPointIds"), reduced, this->GetPointCountArrayName());
  KeepBounds(joined, reduced, this->GetErrorBoundArrayName());
  reduced->GetPointData()->RemoveArray("OriginalPointIds");
  reduced->GetCellData()->RemoveArray("OriginalCellIds");
  return reduced;
}
