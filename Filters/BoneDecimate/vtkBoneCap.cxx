// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneCap.h"

#include "BoundaryLoops.h"
#include "CapTriangles.h"
#include "Pieces.h"
#include "RejectedValues.h"
#include "SurfaceConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace
{
const bonedecimate::NumberRange ChoiceRange = { 0, 1, true, "" };
const bonedecimate::NumberRange ToleranceRange = { 0, bonedecimate::LargestNumber, false, "mm" };

double AreaOf(const bonedecimate::Surface& surface, const bonedecimate::Cap& cap)
{
  const auto at = [&surface](bonedecimate::Index point)
  { return surface.Points[static_cast<std::size_t>(point)]; };
  return std::accumulate(cap.Triangles.begin(), cap.Triangles.end(), 0.0,
    [&at](double sum, const bonedecimate::Triangle& t)
    { return sum + 0.5 * (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm(); });
}

/// The cells of caps behind those of the input, with their arrays.
/// @param neighbors A cell of the input for each cap.
void Append(const std::vector<bonedecimate::Cap>& caps, const std::vector<vtkIdType>& neighbors,
  vtkPolyData* input, vtkPolyData* output)
{
  output->ShallowCopy(input);
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(input->GetPolys());
  vtkNew<vtkUnsignedCharArray> isCap;
  isCap->SetName("BoneCap");
  const vtkIdType before = input->GetNumberOfCells();
  isCap->SetNumberOfValues(before);
  isCap->Fill(0);
  vtkCellData* data = output->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(input->GetCellData(), before);
  data->CopyData(input->GetCellData(), 0, before, 0);
  for (std::size_t cap = 0; cap < caps.size(); ++cap)
  {
    for (const bonedecimate::Triangle& corners : caps[cap].Triangles)
    {
      polygons->InsertNextCell({ corners[0], corners[1], corners[2] });
      data->CopyData(input->GetCellData(), neighbors[cap], isCap->InsertNextValue(1));
    }
  }
  output->SetPolys(polygons);
  data->RemoveArray("BoneCap"); // of an earlier run
  data->AddArray(isCap);
}

/// The points inside of caps, with the values of one of their neighbors; the points of the input themselves if there are none.
void AppendPoints(const bonedecimate::Surface& surface,
  const std::vector<bonedecimate::PointPair>& added, vtkPolyData* input, vtkPolyData* output)
{
  if (added.empty())
  {
    return;
  }
  const vtkIdType before = input->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->DeepCopy(input->GetPoints());
  vtkPointData* data = output->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(input->GetPointData(), before);
  data->CopyData(input->GetPointData(), 0, before, 0);
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    const vtkIdType point =
      points->InsertNextPoint(surface.Points[static_cast<std::size_t>(before) + i].data());
    data->CopyData(input->GetPointData(), std::min<vtkIdType>(added[i].first, before - 1), point);
  }
  output->SetPoints(points);
}

/// Null if there is none.
const char* ReasonToReject(vtkPolyData* input, vtkInformationVector* outputs)
{
  return input->GetNumberOfStrips() > 0
    ? "the input has triangle strips; vtkTriangleFilter makes triangles of them"
    : bonedecimate::RequestedPiece(outputs).Pieces > 1
    ? "vtkBoneCap is for one process alone: the parts of a distributed surface end where others "
      "begin"
    : nullptr;
}
}

struct vtkBoneCap::Internals
{
  bonedecimate::RejectedValues Rejected;
};

vtkStandardNewMacro(vtkBoneCap);

vtkBoneCap::vtkBoneCap()
  : Internal(std::make_unique<Internals>())
{
}

vtkBoneCap::~vtkBoneCap() = default;

//------------------------------------------------------------------------------
void vtkBoneCap::SetLoops(int choice)
{
  this->Internal->Rejected.SetNumber(this, "Loops", ChoiceRange, choice, this->Loops);
}

void vtkBoneCap::SetPlaneTolerance(double tolerance)
{
  this->Internal->Rejected.SetNumber(
    this, "PlaneTolerance", ToleranceRange, tolerance, this->PlaneTolerance);
}

std::string vtkBoneCap::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneCap::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
int vtkBoneCap::RequestData(vtkInformation* vtkNotUsed(request), vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (this->Internal->Rejected.Report(this))
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (const char* reason = ReasonToReject(input, outputVector))
  {
    vtkErrorMacro(<< reason);
    return 0;
  }
  bonedecimate::ConvertedSurface converted = bonedecimate::ToSurface(input, 1);
  bonedecimate::BoundaryLoops found = bonedecimate::FindBoundaryLoops(converted.Surface);
  const std::vector<std::vector<std::size_t>> groups =
    bonedecimate::GroupByEndPlanes(converted.Surface, found.Loops, this->PlaneTolerance);
  std::vector<bool> isClosed(found.Loops.size(), false);
  std::vector<bonedecimate::Cap> caps;
  const auto fill = [&](const std::vector<std::size_t>& group)
  {
    for (bonedecimate::Cap& cap : bonedecimate::FillLoops(converted.Surface, found, group))
    {
      std::for_each(cap.Loops.begin(), cap.Loops.end(),
        [&isClosed](std::size_t loop) { isClosed[loop] = true; });
      caps.push_back(std::move(cap));
    }
  };
  std::for_each(groups.begin(), groups.end(), fill);
  for (std::size_t loop = 0; this->Loops == AllLoops && loop < isClosed.size(); ++loop)
  {
    if (!isClosed[loop])
    {
      fill({ loop });
    }
  }
  this->NumberOfCaps = static_cast<vtkIdType>(caps.size());
  this->NumberOfClosedLoops = std::count(isClosed.begin(), isClosed.end(), true);
  this->NumberOfOpenLoops =
    static_cast<vtkIdType>(isClosed.size() + found.NonManifold) - this->NumberOfClosedLoops;
  this->NumberOfCapTriangles = std::accumulate(caps.begin(), caps.end(), vtkIdType(0),
    [](vtkIdType sum, const bonedecimate::Cap& cap)
    { return sum + static_cast<vtkIdType>(cap.Triangles.size()); });
  this->CapArea = std::accumulate(caps.begin(), caps.end(), 0.0,
    [&](double sum, const bonedecimate::Cap& cap) { return sum + AreaOf(converted.Surface, cap); });
  std::vector<vtkIdType> neighbors;
  std::transform(caps.begin(), caps.end(), std::back_inserter(neighbors),
    [&](const bonedecimate::Cap& cap)
    { return converted(found.Loops[cap.Loops.front()].Triangle); });
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  Append(caps, neighbors, input, output);
  AppendPoints(converted.Surface, found.Added, input, output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneCap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Loops: " << this->Loops << "\n";
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << "\n";
  os << indent << "NumberOfCaps: " << this->NumberOfCaps << "\n";
  os << indent << "NumberOfCapTriangles: " << this->NumberOfCapTriangles << "\n";
  os << indent << "CapArea: " << this->CapArea << "\n";
  os << indent << "NumberOfClosedLoops: " << this->NumberOfClosedLoops << "\n";
  os << indent << "NumberOfOpenLoops: " << this->NumberOfOpenLoops << "\n";
}
