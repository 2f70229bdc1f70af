// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryStrips.h"
#include "Plan.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace
{
vtkDataArray* PointValues(vtkPolyData* surface, const std::string& name)
{
  return surface->GetPointData()->GetArray(name.c_str());
}

/// Number of triangles with a corner at one of the positions.
double TrianglesAt(vtkPolyData* surface, const bonedecimate::Positions& positions)
{
  double count = 0.0;
  vtkNew<vtkIdList> corners;
  surface->BuildCells();
  for (vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
       cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    const bool isThere = std::any_of(corners->begin(), corners->end(),
      [&](vtkIdType corner)
      { return bonedecimate::Contains(positions, surface->GetPoint(corner)); });
    count += isThere ? 1.0 : 0.0;
  }
  return count;
}

void SetPointValues(
  vtkPolyData* surface, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  surface->GetPointData()->AddArray(array);
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
}

//------------------------------------------------------------------------------
/// mm; 0: none.
double vtkPBoneDecimate::LargestError(double voxelSize) const
{
  static const double ratios[] = { 0.0, 0.25, 0.5, 1.0 }; // as in ErrorPresets
  const double size = this->GetVoxelSize() > 0.0 ? this->GetVoxelSize() : voxelSize;
  const double ofVoxel = ratios[this->GetErrorPreset()] * size;
  const double own = this->GetMaximumError();
  return own > 0.0 && ofVoxel > 0.0 ? std::min(own, ofVoxel) : std::max(own, ofVoxel);
}

//------------------------------------------------------------------------------
/// mm, of the bounding box of all parts.
double vtkPBoneDecimate::WholeDiagonal(vtkPolyData* input) const
{
  double bounds[6];
  input->GetBounds(bounds);
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isEmpty = input->GetNumberOfPoints() == 0;
    const double none = std::numeric_limits<double>::infinity();
    const double least = this->OfAll(isEmpty ? none : bounds[2 * axis], vtkCommunicator::MIN_OP);
    const double most =
      this->OfAll(isEmpty ? -none : bounds[2 * axis + 1], vtkCommunicator::MAX_OP);
    squares += (most - least) * (most - least);
  }
  return std::sqrt(squares);
}

//------------------------------------------------------------------------------
/// As on one process: the default reduction is ignored beside other targets, and the first target that is reached ends the run.
double vtkPBoneDecimate::TargetTriangles(double total, double error, bool isLimited) const
{
  const double number = this->GetTargetNumberOfTriangles();
  const bool anyOther =
    isLimited || number > 0.0 || error > 0.0 || this->GetKeepVoxels() == KEEP_VOXELS_ON;
  const bool reduces =
    this->GetTargetReduction() < 1.0 && (this->IsTargetReductionSet() || !anyOther);
  return std::max(
    number, reduces ? std::floor(total * (1.0 - this->GetTargetReduction()) + 0.5) : 0.0);
}

//------------------------------------------------------------------------------
/// Whether every point of every process has a tolerance.
bool vtkPBoneDecimate::IsLimitedEverywhere(vtkPolyData* input)
{
  vtkDataArray* tolerances = this->GetPointTolerances(input);
  bool isLimited = tolerances != nullptr || input->GetNumberOfPoints() == 0;
  for (vtkIdType i = 0; tolerances && i < tolerances->GetNumberOfTuples(); ++i)
  {
    isLimited = isLimited && tolerances->GetComponent(i, 0) >= 0.0;
  }
  return this->OfAll(isLimited ? 1.0 : 0.0, vtkCommunicator::MIN_OP) > 0.0;
}

//------------------------------------------------------------------------------
vtkPBoneDecimate::Plan vtkPBoneDecimate::MakePlan(
  vtkPolyData* input, vtkPolyData* reference, double voxelSize)
{
  Plan plan;
  plan.VoxelSize = voxelSize;
  plan.Error = this->LargestError(voxelSize);
  plan.GuardsVoxels = this->IsTrueAnywhere(this->GuardsVoxels(input, plan.Error));
  plan.Shared = bonedecimate::SharedPositions(input, this->Controller);
  plan.SharedPoints = static_cast<double>(plan.Shared.size());
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    plan.IsShared.push_back(bonedecimate::Contains(plan.Shared, input->GetPoint(point)) ? 1 : 0);
  }
  const double own = static_cast<double>(input->GetNumberOfPolys());
  const double constrained = TrianglesAt(input, plan.Shared);
  plan.Total = this->OfAll(own, vtkCommunicator::SUM_OP);
  const double allConstrained = this->OfAll(constrained, vtkCommunicator::SUM_OP);
  plan.Target = this->TargetTriangles(plan.Total, plan.Error, this->IsLimitedEverywhere(input));
  const bool hasReference = this->IsTrueAnywhere(reference != nullptr);
  plan.ReducesStrips = !plan.Shared.empty() && plan.Target < plan.Total && !hasReference &&
    !this->HasInputArray(TOLERANCE_ARRAY) && !(this->GetMode() == THESIS && plan.Error > 0.0);
  // Strips that are reduced later count with their target, all others as they are.
  const double ratio = plan.ReducesStrips
    ? plan.Target / std::max(plan.Total, 1.0)
    : (plan.Target - allConstrained) / std::max(plan.Total - allConstrained, 1.0);
  plan.TargetHere = plan.Target > 0.0
    ? std::max(1.0, constrained + std::floor(std::max(ratio, 0.0) * (own - constrained) + 0.5))
    : 0.0;
  return plan;
}

//------------------------------------------------------------------------------
void vtkPBoneDecimate::Order(
  vtkPBoneDecimate* run, double triangles, double error, const Plan& plan) const
{
  run->CopyOptions(*this);
  run->SetTargetNumberOfTriangles(
    static_cast<int>(std::min<double>(triangles, std::numeric_limits<int>::max())));
  run->SetTargetReduction(1.0); // is in the number
  run->SetMaximumError(error);
  run->SetErrorPreset(NO_PRESET);
  run->SetSmoothing(0.0); // is done for all parts together
  run->SetAutomaticSmoothing(false);
  run->SetFeatureAngle(180.0);
  run->SetKeepVoxels(plan.GuardsVoxels ? KEEP_VOXELS_ON : KEEP_VOXELS_OFF);
  run->SetMakeMaps(false);
  run->SetOutputPointsPrecision(DEFAULT_PRECISION); // constrained points keep their bits
}

//------------------------------------------------------------------------------
/// Phase 1. False if the part was rejected.
bool vtkPBoneDecimate::ReducePart(
  vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference, const Plan& plan)
{
  this->Order(run, plan.TargetHere, plan.ErrorOfParts(), plan);
  run->SetPart(plan.IsShared, plan.SmoothedPoints);
  return this->Run(run, input, reference);
}

//------------------------------------------------------------------------------
/// Phase 2: process 0 gets the result of the strips of all processes.
void vtkPBoneDecimate::ReduceSharedStrips(
  vtkPolyData* input, Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy)
{
  const bonedecimate::StripParts parts = bonedecimate::CutStrips(output, plan.Shared);
  const double strip = static_cast<double>(parts.Strip->GetNumberOfPolys());
  const double rest = static_cast<double>(parts.Rest->GetNumberOfPolys());
  plan.StripsBefore = this->OfAll(strip, vtkCommunicator::SUM_OP);
  const double left = plan.Target - this->OfAll(rest, vtkCommunicator::SUM_OP);
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  this->Controller->Gather(parts.Strip, received, 0);
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  auto reduced = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPBoneDecimate> run;
  if (isFirst)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> strips;
    strips.reserve(received.size());
    for (vtkDataObject* one : received)
    {
      strips.emplace_back(vtkPolyData::SafeDownCast(one));
    }
    reduced = bonedecimate::Join(strips);
    const double triangles = plan.Target > 0.0 ? std::max(left, 1.0) : 0.0;
    if (reduced->GetNumberOfPolys() > 0 && this->ReduceStrips(run, reduced, plan, triangles))
    {
      reduced = run->GetOutput();
    }
  }
  this->Controller->Broadcast(reduced, 0);
  plan.StripsAfter = static_cast<double>(reduced->GetNumberOfPolys());
  plan.Proved += this->ProvedByAll(run);
  this->AddCounts(run, plan);
  this->MeasureAnew(input, parts.Rest, reduced, inputCopy);
  const auto whole = isFirst ? bonedecimate::Join({ parts.Rest, reduced }) : parts.Rest;
  whole->GetFieldData()->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(whole);
}

//------------------------------------------------------------------------------
/// False if they were rejected.
bool vtkPBoneDecimate::ReduceStrips(
  vtkPBoneDecimate* run, vtkPolyData* strips, const Plan& plan, double triangles)
{
  this->Order(run, triangles, plan.Error - plan.ErrorOfParts(), plan);
  run->SetPart(bonedecimate::TakeRim(strips), {});
  run->SetMergePoints(true); // that is what joins them
  run->SetMakeMaps(true);
  run->SetMeasureDistances(false);
  run->SetMeasureInputDistances(false);
  if (!this->Run(run, strips, nullptr))
  {
    return false;
  }
  vtkPolyData* reduced = run->GetOutput();
  vtkPolyData* copy = vtkPolyData::SafeDownCast(run->GetOutputDataObject(1));
  SumCounts(strips, PointValues(copy, "ResultPointIds"), reduced, this->GetPointCountArrayName());
  reduced->GetPointData()->RemoveArray("OriginalPointIds");
  reduced->GetCellData()->RemoveArray("OriginalCellIds");
  vtkDataArray* bounds = PointValues(reduced, this->GetErrorBoundArrayName());
  for (vtkIdType i = 0; bounds && i < bounds->GetNumberOfTuples(); ++i)
  {
    bounds->SetComponent(i, 0, bounds->GetComponent(i, 0) + plan.Proved);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Distances that phase 2 changed, each to the surfaces of all processes or, of input points, to those at hand.
void vtkPBoneDecimate::MeasureAnew(
  vtkPolyData* input, vtkPolyData* rest, vtkPolyData* reduced, vtkPolyData* inputCopy)
{
  if (this->GetMeasureDistances() || this->GetMode() == THESIS)
  {
    std::vector<double> own = bonedecimate::DistancesTo(input, reduced->GetPoints());
    std::vector<double> least = own;
    this->Controller->AllReduce(
      own.data(), least.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
    SetPointValues(reduced, this->GetDistanceArrayName(), least);
    SetPointValues(reduced, this->GetRunningErrorArrayName(), least);
  }
  else
  {
    // Those of phase 2 are distances to what phase 1 left, not to the input.
    for (vtkPolyData* surface : { rest, reduced })
    {
      surface->GetPointData()->RemoveArray(this->GetDistanceArrayName().c_str());
      surface->GetPointData()->RemoveArray(this->GetRunningErrorArrayName().c_str());
    }
  }
  if (this->GetMeasureInputDistances())
  {
    std::vector<double> nearest = bonedecimate::DistancesTo(rest, input->GetPoints());
    const std::vector<double> toStrips = bonedecimate::DistancesTo(reduced, input->GetPoints());
    std::transform(nearest.begin(), nearest.end(), toStrips.begin(), nearest.begin(),
      [](double a, double b) { return std::min(a, b); });
    SetPointValues(inputCopy, this->GetInputDistanceArrayName(), nearest);
    inputCopy->GetPointData()->RemoveArray(this->GetInputErrorBoundArrayName().c_str());
  }
}

//------------------------------------------------------------------------------
/// Of the whole surface, the same on every process.
void vtkPBoneDecimate::Report(const Plan& plan, vtkPolyData* output)
{
  const double own = static_cast<double>(output->GetNumberOfPolys());
  std::map<std::string, double> entries = { { "input.triangles", plan.Total },
    { "output.triangles", this->OfAll(own, vtkCommunicator::SUM_OP) },
    { "parallel.processes", this->Controller->GetNumberOfProcesses() },
    { "parallel.shared_points", plan.SharedPoints },
    { "parallel.strip_triangles_before", plan.StripsBefore },
    { "parallel.strip_triangles_after", plan.StripsAfter } };
  if (!std::isnan(plan.Proved))
  {
    entries["proof.upper"] = plan.Proved;
  }
  entries.insert(plan.Counts.begin(), plan.Counts.end());
  this->SetReportOfParts(entries, output);
}
