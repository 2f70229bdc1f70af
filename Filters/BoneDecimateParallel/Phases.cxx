// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"
#include "SeamStrips.h"

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

namespace
{
const std::string ReportPrefix = "bonedecimate.";

vtkDataArray* PointValues(vtkPolyData* surface, const std::string& name)
{
  return surface->GetPointData()->GetArray(name.c_str());
}

/// How many triangles have a corner at one of the places.
double TrianglesAt(vtkPolyData* surface, const bonedecimate::Places& places)
{
  double count = 0.0;
  vtkNew<vtkIdList> corners;
  surface->BuildCells();
  for (vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
       cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    const bool isThere = std::any_of(corners->begin(), corners->end(),
      [&](vtkIdType corner) { return bonedecimate::Contains(places, surface->GetPoint(corner)); });
    count += isThere ? 1.0 : 0.0;
  }
  return count;
}

void AddNumber(vtkPolyData* surface, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName((ReportPrefix + name).c_str());
  array->InsertNextValue(value);
  surface->GetFieldData()->AddArray(array);
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

/// What each point of the result stands for: the sum of what the points stood for that became part of it.
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
double vtkPBoneDecimate::LargestError() const
{
  static const double shares[] = { 0.0, 0.25, 0.5, 1.0 }; // as in ErrorPresets
  const double ofVoxel = shares[this->GetErrorPreset()] * this->GetVoxelSize();
  const double asked = this->GetMaximumError();
  return asked > 0.0 && ofVoxel > 0.0 ? std::min(asked, ofVoxel) : std::max(asked, ofVoxel);
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
/// As on one process: the default reduction steps back, the first stop reached counts.
double vtkPBoneDecimate::TrianglesWanted(double total, bool isLimited) const
{
  const double number = this->GetTargetNumberOfTriangles();
  const bool anyOther = isLimited || number > 0.0 || this->LargestError() > 0.0;
  const bool reduces =
    this->GetTargetReduction() < 1.0 && (this->IsTargetReductionSet() || !anyOther);
  return std::max(
    number, reduces ? std::floor(total * (1.0 - this->GetTargetReduction()) + 0.5) : 0.0);
}

//------------------------------------------------------------------------------
/// Whether every point of every process has a tolerance.
bool vtkPBoneDecimate::IsLimitedEverywhere(vtkPolyData* input) const
{
  vtkDataArray* tolerances = PointValues(input, this->GetToleranceArrayName());
  bool isLimited = tolerances != nullptr || input->GetNumberOfPoints() == 0;
  for (vtkIdType i = 0; tolerances && i < tolerances->GetNumberOfTuples(); ++i)
  {
    isLimited = isLimited && tolerances->GetComponent(i, 0) >= 0.0;
  }
  return this->OfAll(isLimited ? 1.0 : 0.0, vtkCommunicator::MIN_OP) > 0.0;
}

//------------------------------------------------------------------------------
vtkPBoneDecimate::Plan vtkPBoneDecimate::MakePlan(vtkPolyData* input, vtkPolyData* reference) const
{
  Plan plan;
  plan.Shared = bonedecimate::SharedPlaces(bonedecimate::BorderPlaces(input), this->Controller);
  const double own = static_cast<double>(input->GetNumberOfPolys());
  const double frozen = TrianglesAt(input, plan.Shared);
  plan.Total = this->OfAll(own, vtkCommunicator::SUM_OP);
  const double allFrozen = this->OfAll(frozen, vtkCommunicator::SUM_OP);
  plan.Wanted = this->TrianglesWanted(plan.Total, this->IsLimitedEverywhere(input));
  plan.Error = this->LargestError();
  const bool hasReference = this->OfAll(reference ? 1.0 : 0.0, vtkCommunicator::MAX_OP) > 0.0;
  plan.ReducesSeams = !plan.Shared.empty() && !hasReference &&
    this->GetToleranceArrayName().empty() && !(this->GetMode() == THESIS && plan.Error > 0.0);
  // Seams that will be reduced later count as they will be; seams that stay count as they are.
  const double share = plan.ReducesSeams
    ? plan.Wanted / std::max(plan.Total, 1.0)
    : (plan.Wanted - allFrozen) / std::max(plan.Total - allFrozen, 1.0);
  plan.WantedHere = plan.Wanted > 0.0
    ? std::max(1.0, frozen + std::floor(std::max(share, 0.0) * (own - frozen) + 0.5))
    : 0.0;
  return plan;
}

//------------------------------------------------------------------------------
void vtkPBoneDecimate::Order(vtkPBoneDecimate* run, double triangles, double error) const
{
  run->CopyOptions(*this, true);
  run->SetTargetNumberOfTriangles(
    static_cast<int>(std::min<double>(triangles, std::numeric_limits<int>::max())));
  run->SetTargetReduction(1.0); // is in the number
  run->SetMaximumError(error);
  run->SetErrorPreset(NO_PRESET);
  run->SetMakeMaps(false);
  run->SetOutputPointsPrecision(DEFAULT_PRECISION); // frozen points stay bit for bit
}

//------------------------------------------------------------------------------
/// Phase 1. False if the part was refused.
bool vtkPBoneDecimate::ReducePart(
  vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference, const Plan& plan)
{
  this->Order(run, plan.WantedHere, plan.Error * (plan.ReducesSeams ? Plan::ShareOfParts : 1.0));
  const std::string& name = this->GetToleranceArrayName();
  vtkDataArray* asked = PointValues(input, name);
  if (!name.empty() && (!asked || asked->GetNumberOfComponents() != 1))
  {
    return this->Run(run, input, reference); // which says what is wrong
  }
  std::vector<double> tolerances(static_cast<std::size_t>(input->GetNumberOfPoints()), -1.0);
  for (std::size_t i = 0; i < tolerances.size(); ++i)
  {
    const vtkIdType point = static_cast<vtkIdType>(i);
    const double own = asked ? asked->GetComponent(point, 0) : -1.0;
    tolerances[i] = bonedecimate::Contains(plan.Shared, input->GetPoint(point)) ? 0.0 : own;
  }
  vtkNew<vtkPolyData> marked;
  marked->ShallowCopy(input);
  SetPointValues(marked, Plan::ToleranceName, tolerances);
  run->SetToleranceArrayName(Plan::ToleranceName);
  return this->Run(run, marked, reference);
}

//------------------------------------------------------------------------------
/// Phase 2: what the strips of all processes become is process 0's.
void vtkPBoneDecimate::ReduceSeams(
  vtkPolyData* input, Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy)
{
  const bonedecimate::SeamParts parts = bonedecimate::CutSeams(output, plan.Shared);
  const double strip = static_cast<double>(parts.Strip->GetNumberOfPolys());
  const double rest = static_cast<double>(parts.Rest->GetNumberOfPolys());
  plan.SeamsBefore = this->OfAll(strip, vtkCommunicator::SUM_OP);
  const double left = plan.Wanted - this->OfAll(rest, vtkCommunicator::SUM_OP);
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  this->Controller->Gather(parts.Strip, received, 0);
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  auto seams = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPBoneDecimate> run;
  if (isFirst)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> strips;
    strips.reserve(received.size());
    for (vtkDataObject* one : received)
    {
      strips.emplace_back(vtkPolyData::SafeDownCast(one));
    }
    seams = bonedecimate::Join(strips);
    const double triangles = plan.Wanted > 0.0 ? std::max(left, 1.0) : 0.0;
    if (this->ReduceStrips(run, seams, plan, triangles))
    {
      seams = run->GetOutput();
    }
  }
  this->Controller->Broadcast(seams, 0);
  plan.SeamsAfter = static_cast<double>(seams->GetNumberOfPolys());
  plan.Proved += this->ProvedByAll(run);
  this->MeasureAnew(input, parts.Rest, seams, inputCopy);
  const auto whole = isFirst ? bonedecimate::Join({ parts.Rest, seams }) : parts.Rest;
  whole->GetFieldData()->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(whole);
}

//------------------------------------------------------------------------------
/// False if they were refused.
bool vtkPBoneDecimate::ReduceStrips(
  vtkPBoneDecimate* run, vtkPolyData* strips, const Plan& plan, double triangles)
{
  this->Order(run, triangles, plan.Error * (1.0 - Plan::ShareOfParts));
  run->SetToleranceArrayName(bonedecimate::RimArrayName);
  run->SetMergePoints(true); // that is what joins them
  run->SetMakeMaps(true);
  run->SetMeasureDistances(false);
  run->SetMeasureInputDistances(false);
  if (!this->Run(run, strips, nullptr))
  {
    return false;
  }
  vtkPolyData* seams = run->GetOutput();
  vtkPolyData* copy = vtkPolyData::SafeDownCast(run->GetOutputDataObject(1));
  SumCounts(strips, PointValues(copy, "ResultPointIds"), seams, this->GetPointCountArrayName());
  seams->GetPointData()->RemoveArray("OriginalPointIds");
  seams->GetCellData()->RemoveArray("OriginalCellIds");
  vtkDataArray* bounds = PointValues(seams, this->GetErrorBoundArrayName());
  for (vtkIdType i = 0; bounds && i < bounds->GetNumberOfTuples(); ++i)
  {
    bounds->SetComponent(i, 0, bounds->GetComponent(i, 0) + plan.Proved);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Distances that phase 2 changed, each to the surfaces of all processes or, of input points, to those at hand.
void vtkPBoneDecimate::MeasureAnew(
  vtkPolyData* input, vtkPolyData* rest, vtkPolyData* seams, vtkPolyData* inputCopy)
{
  if (this->GetMeasureDistances() || this->GetMode() == THESIS)
  {
    std::vector<double> own = bonedecimate::DistancesTo(input, seams->GetPoints());
    std::vector<double> least = own;
    this->Controller->AllReduce(
      own.data(), least.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
    SetPointValues(seams, this->GetDistanceArrayName(), least);
    SetPointValues(seams, this->GetRunningErrorArrayName(), least);
  }
  else
  {
    // Those of phase 2 are distances to what phase 1 left, not to the input.
    for (vtkPolyData* surface : { rest, seams })
    {
      surface->GetPointData()->RemoveArray(this->GetDistanceArrayName().c_str());
      surface->GetPointData()->RemoveArray(this->GetRunningErrorArrayName().c_str());
    }
  }
  if (this->GetMeasureInputDistances())
  {
    std::vector<double> nearest = bonedecimate::DistancesTo(rest, input->GetPoints());
    const std::vector<double> toSeams = bonedecimate::DistancesTo(seams, input->GetPoints());
    std::transform(nearest.begin(), nearest.end(), toSeams.begin(), nearest.begin(),
      [](double a, double b) { return std::min(a, b); });
    SetPointValues(inputCopy, this->GetInputDistanceArrayName(), nearest);
    inputCopy->GetPointData()->RemoveArray(this->GetInputErrorBoundArrayName().c_str());
  }
}

//------------------------------------------------------------------------------
/// Of the whole surface, the same on every process; entries of a part would be taken for it.
void vtkPBoneDecimate::Report(const Plan& plan, vtkPolyData* output) const
{
  vtkFieldData* entries = output->GetFieldData();
  for (int i = entries->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (std::string(entries->GetArrayName(i)).rfind(ReportPrefix, 0) == 0)
    {
      entries->RemoveArray(i);
    }
  }
  const double own = static_cast<double>(output->GetNumberOfPolys());
  AddNumber(output, "input.faces", plan.Total);
  AddNumber(output, "output.faces", this->OfAll(own, vtkCommunicator::SUM_OP));
  if (!std::isnan(plan.Proved))
  {
    AddNumber(output, "proof.upper", plan.Proved);
  }
  AddNumber(output, "parallel.processes", this->Controller->GetNumberOfProcesses());
  AddNumber(output, "parallel.shared_points", static_cast<double>(plan.Shared.size()));
  AddNumber(output, "parallel.seam_faces_before", plan.SeamsBefore);
  AddNumber(output, "parallel.seam_faces_after", plan.SeamsAfter);
}
