// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryStrips.h"
#include "Gathering.h"
#include "Plan.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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
/// As on one process: the default reduction is ignored beside other targets, and the first target
/// that is reached ends the run.
double vtkPBoneDecimate::TargetTriangles(double total, double error, bool isLimited) const
{
  const double reduced = this->Internal->EndsAtReduction(isLimited || error > 0.0)
    ? std::floor(total * (1.0 - this->GetTargetReduction()) + 0.5)
    : 0.0;
  return std::max(static_cast<double>(this->GetTargetNumberOfTriangles()), reduced);
}

//------------------------------------------------------------------------------
/// Whether every point of every process has a tolerance.
bool vtkPBoneDecimate::IsLimitedEverywhere(vtkPolyData* input)
{
  vtkDataArray* tolerances = this->Internal->GetPointTolerances(input);
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
  plan.Error = this->Internal->LargestErrorOf(voxelSize);
  plan.ProvesError = plan.Error > 0.0 && this->GetMode() != THESIS;
  plan.GuardsVoxels = this->IsTrueAnywhere(this->Internal->GuardsVoxels(input, plan.Error));
  plan.Shared = bonedecimate::SharedPositions(input, this->Controller);
  plan.SharedPoints = static_cast<double>(plan.Shared.size());
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    plan.IsShared.push_back(bonedecimate::Contains(plan.Shared, input->GetPoint(point)) ? 1 : 0);
  }
  this->FindNeighbors(input, plan);
  const double own = static_cast<double>(input->GetNumberOfPolys());
  const std::vector<bool> unchanged = this->UnchangedCells(input, plan);
  const auto constrained =
    static_cast<double>(std::count(unchanged.begin(), unchanged.end(), true));
  plan.Total = this->OfAll(own, vtkCommunicator::SUM_OP);
  const double allConstrained = this->OfAll(constrained, vtkCommunicator::SUM_OP);
  plan.Target = this->TargetTriangles(plan.Total, plan.Error, this->IsLimitedEverywhere(input));
  const bool hasReference = this->IsTrueAnywhere(reference != nullptr);
  const bool hasUnchanged = this->IsTrueAnywhere(constrained > 0.0);
  plan.ReducesStrips = hasUnchanged && plan.Target < plan.Total && !hasReference &&
    !this->Internal->HasInputArray(TOLERANCE_ARRAY) &&
    !(this->GetMode() == THESIS && plan.Error > 0.0);
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
void vtkPBoneDecimate::Order(vtkPBoneDecimate* run, double triangles, const Plan& plan)
{
  run->Internal->CopyOptions(*this);
  run->SetTargetNumberOfTriangles(
    static_cast<int>(std::min<double>(triangles, std::numeric_limits<int>::max())));
  run->SetTargetReduction(1.0); // is in the number
  run->SetMaximumError(plan.Error);
  run->SetErrorPreset(NO_PRESET);
  run->SetSmoothing(0.0); // is done for all parts together
  run->SetAutomaticSmoothing(false);
  run->SetFeatureAngle(180.0);
  run->SetKeepVoxels(plan.GuardsVoxels ? KEEP_VOXELS_ON : KEEP_VOXELS_OFF);
  if (this->Internal->HasInputArray(LABEL_ARRAY))
  {
    run->SetLabelArrayName(bonedecimate::CellLabelsName);
  }
  run->SetMakeMaps(false);
  run->SetOutputPointsPrecision(DEFAULT_PRECISION); // constrained points keep their bits
}

//------------------------------------------------------------------------------
/// Phase 1. False if the part was rejected.
bool vtkPBoneDecimate::ReducePart(
  vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference, const Plan& plan)
{
  this->Order(run, plan.TargetHere, plan);
  run->Internal->SetPart(plan.IsShared, plan.SmoothedPoints);
  if (plan.ProvesError)
  {
    run->Internal->SetNeighborsOfPart(plan.Neighbors, plan.NeighborDistance());
  }
  return this->Run(run, input, reference);
}

//------------------------------------------------------------------------------
/// Distances that phase 2 changed, each to the surfaces of all processes.
void vtkPBoneDecimate::MeasureAnew(vtkPolyData* input, vtkPolyData* rest, vtkPolyData* reduced)
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
    // Errors of phase 2 are distances to the result of phase 1, not to the input.
    for (vtkPolyData* surface : { rest, reduced })
    {
      surface->GetPointData()->RemoveArray(this->GetDistanceArrayName().c_str());
      surface->GetPointData()->RemoveArray(this->GetRunningErrorArrayName().c_str());
    }
  }
}

//------------------------------------------------------------------------------
/// @param result What is at hand of it: distances of input points are to its nearest.
void vtkPBoneDecimate::FillInputCopy(
  vtkPolyData* input, const std::vector<vtkPolyData*>& result, vtkPolyData* inputCopy)
{
  if (inputCopy->GetNumberOfPoints() < input->GetNumberOfPoints())
  {
    inputCopy->ShallowCopy(input); // phase 1 did not have what was pruned
  }
  if (this->GetMeasureInputDistances())
  {
    std::vector<double> nearest(static_cast<std::size_t>(input->GetNumberOfPoints()),
      std::numeric_limits<double>::infinity());
    for (vtkPolyData* surface : result)
    {
      const std::vector<double> distances = bonedecimate::DistancesTo(surface, input->GetPoints());
      std::transform(nearest.begin(), nearest.end(), distances.begin(), nearest.begin(),
        [](double a, double b) { return std::min(a, b); });
    }
    SetPointValues(inputCopy, this->GetInputDistanceArrayName(), nearest);
    inputCopy->GetPointData()->RemoveArray(this->GetInputErrorBoundArrayName().c_str());
  }
}

//------------------------------------------------------------------------------
/// Those at the points of all processes, if they were measured.
/// @param direction "output_to_input" or "input_to_output"
void vtkPBoneDecimate::AddDistances(
  vtkPolyData* surface, const std::string& array, const std::string& direction, Plan& plan) const
{
  vtkDataArray* distances = surface->GetPointData()->GetArray(array.c_str());
  double largest = 0.0;
  double sum = 0.0;
  const vtkIdType count = distances != nullptr ? distances->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    largest = std::max(largest, distances->GetComponent(i, 0));
    sum += distances->GetComponent(i, 0);
  }
  largest = this->OfAll(largest, vtkCommunicator::MAX_OP);
  sum = this->OfAll(sum, vtkCommunicator::SUM_OP);
  const double points = this->OfAll(static_cast<double>(count), vtkCommunicator::SUM_OP);
  if (points > 0.0)
  {
    plan.Figures["distance." + direction + ".max"] = largest;
    plan.Figures["distance." + direction + ".mean"] = sum / points;
  }
}

//------------------------------------------------------------------------------
/// Reports on the whole surface, the same on every process.
void vtkPBoneDecimate::Report(Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy)
{
  const double own = static_cast<double>(output->GetNumberOfPolys());
  const double triangles = this->OfAll(own, vtkCommunicator::SUM_OP);
  std::map<std::string, double>& figures = plan.Figures;
  figures["input.triangles"] = plan.Total;
  figures["output.triangles"] = triangles;
  figures["parallel.processes"] = this->Controller->GetNumberOfProcesses();
  figures["parallel.shared_points"] = plan.SharedPoints;
  figures["parallel.strip_triangles_before"] = plan.StripsBefore;
  figures["parallel.strip_triangles_after"] = plan.StripsAfter;
  this->Internal->AddComponents("output", output, this->MeetingOf(output), figures);
  this->AddDistances(output, this->GetDistanceArrayName(), "output_to_input", plan);
  this->AddDistances(inputCopy, this->GetInputDistanceArrayName(), "input_to_output", plan);
  if (!std::isnan(plan.Proved))
  {
    figures["proof.upper"] = plan.Proved;
    figures["proof.tolerance"] = plan.Error;
  }
  if (plan.StopReason != ABORTED && plan.Target > 0.0 && triangles <= plan.Target)
  {
    plan.StopReason = plan.Total <= plan.Target ? ALREADY_SATISFIED : TARGET_REACHED;
  }
  this->Internal->SetReportOfParts(figures, plan.StopReason, plan.ProofStatus,
    bonedecimate::AllNumbers(this->Internal->FiguresOfPart(output), this->Controller), output);
}
