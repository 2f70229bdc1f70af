// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneCap.h"

#include "Pieces.h"
#include "RejectedValues.h"
#include "Repair/Caps/CloseBoundaries.h"
#include "SurfaceConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourTriangulator.h"
#include "vtkIdList.h"
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

namespace
{
const bonedecimate::NumberRange ChoiceRange = { 0, 1, true, "" };
const bonedecimate::NumberRange ToleranceRange = { 0, bonedecimate::MaxNumber, false, "mm" };

std::vector<bonedecimate::Triangle> Triangulate(const bonedecimate::Contours& contours)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const bonedecimate::Vector3& point : contours.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> lines;
  for (std::size_t contour = 0; contour + 1 < contours.Starts.size(); ++contour)
  {
    const vtkIdType begin = contours.Starts[contour];
    const vtkIdType end = contours.Starts[contour + 1];
    for (vtkIdType i = begin; i < end; ++i)
    {
      lines->InsertNextCell({ i, i + 1 < end ? i + 1 : begin });
    }
  }
  vtkNew<vtkPolyData> outlines;
  outlines->SetPoints(points);
  outlines->SetLines(lines);
  vtkNew<vtkCellArray> polygons;
  vtkContourTriangulator::TriangulateContours(
    outlines, 0, lines->GetNumberOfCells(), polygons, contours.Normal.data());
  std::vector<bonedecimate::Triangle> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->GetCellAtId(cell, ids);
    if (ids->GetNumberOfIds() != 3)
    {
      return {};
    }
    bonedecimate::Triangle corners{};
    std::transform(ids->begin(), ids->end(), corners.begin(),
      [](vtkIdType id) { return static_cast<bonedecimate::Index>(id); });
    triangles.push_back(corners);
  }
  return triangles;
}

/// Appends the cells of caps to those of the input, with their arrays.
/// @param converted Maps triangles to cells of the input.
void Append(const bonedecimate::CapsOfSurface& caps,
  const bonedecimate::ConvertedSurface& converted, vtkPolyData* input, vtkPolyData* output)
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
  data->Initialize(); // what is copied gets arrays of its own
  data->CopyAllOn();
  data->CopyAllocate(input->GetCellData(), before);
  data->CopyData(input->GetCellData(), 0, before, 0);
  for (std::size_t i = 0; i < caps.Triangles.size(); ++i)
  {
    const bonedecimate::Triangle& corners = caps.Triangles[i];
    polygons->InsertNextCell({ corners[0], corners[1], corners[2] });
    const vtkIdType neighbor = converted(static_cast<std::size_t>(caps.Neighbors[i]));
    data->CopyData(input->GetCellData(), neighbor, isCap->InsertNextValue(1));
  }
  output->SetPolys(polygons);
  data->RemoveArray("BoneCap"); // of an earlier run
  data->AddArray(isCap);
}

/// The points inside of caps, with the values of one of their neighbors; the points of the input
/// themselves if there are none.
void AppendPoints(const bonedecimate::CapsOfSurface& caps, vtkPolyData* input, vtkPolyData* output)
{
  if (caps.Points.empty())
  {
    return;
  }
  const vtkIdType before = input->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->DeepCopy(input->GetPoints());
  vtkPointData* data = output->GetPointData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(input->GetPointData(), before);
  data->CopyData(input->GetPointData(), 0, before, 0);
  for (std::size_t i = 0; i < caps.Points.size(); ++i)
  {
    const vtkIdType point = points->InsertNextPoint(caps.Points[i].data());
    const vtkIdType neighbor = std::min<vtkIdType>(caps.Ends[i].first, before - 1);
    data->CopyData(input->GetPointData(), neighbor, point);
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

vtkStandardNewMacro(vtkBoneCap);

vtkBoneCap::vtkBoneCap() = default;

vtkBoneCap::~vtkBoneCap() = default;

//------------------------------------------------------------------------------
void vtkBoneCap::SetLoops(int choice)
{
  this->Rejected().SetNumber(this, "Loops", ChoiceRange, choice, this->Loops);
}

void vtkBoneCap::SetPlaneTolerance(double tolerance)
{
  this->Rejected().SetNumber(
    this, "PlaneTolerance", ToleranceRange, tolerance, this->PlaneTolerance);
}

//------------------------------------------------------------------------------
/// Before the first run, and after an update that did not get here, nothing.
vtkBoneCap::Results vtkBoneCap::Last() const
{
  return this->IsOutdated() ? Results() : this->Found;
}

vtkIdType vtkBoneCap::GetNumberOfCaps() const
{
  return this->Last().Caps;
}

vtkIdType vtkBoneCap::GetNumberOfCapTriangles() const
{
  return this->Last().Triangles;
}

double vtkBoneCap::GetCapArea() const
{
  return this->Last().Area;
}

vtkIdType vtkBoneCap::GetNumberOfClosedLoops() const
{
  return this->Last().ClosedLoops;
}

vtkIdType vtkBoneCap::GetNumberOfOpenLoops() const
{
  return this->Last().OpenLoops;
}

//------------------------------------------------------------------------------
int vtkBoneCap::RequestData(vtkInformation* vtkNotUsed(request), vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  this->Found = {};
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (const char* reason = ReasonToReject(input, outputVector))
  {
    vtkErrorMacro(<< reason);
    return 0;
  }
  const bonedecimate::ConvertedSurface converted = bonedecimate::ToSurface(input, 1);
  const bonedecimate::CapsOfSurface caps = bonedecimate::CloseBoundaries(
    converted.Surface, { this->Loops == AllLoops, this->PlaneTolerance }, Triangulate);
  this->Found = { caps.NumberOfCaps, static_cast<vtkIdType>(caps.Triangles.size()), caps.Area,
    caps.ClosedLoops, caps.OpenLoops };
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  Append(caps, converted, input, output);
  AppendPoints(caps, input, output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneCap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Loops: " << this->Loops << "\n";
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << "\n";
  os << indent << "NumberOfCaps: " << this->GetNumberOfCaps() << "\n";
  os << indent << "NumberOfCapTriangles: " << this->GetNumberOfCapTriangles() << "\n";
  os << indent << "CapArea: " << this->GetCapArea() << "\n";
  os << indent << "NumberOfClosedLoops: " << this->GetNumberOfClosedLoops() << "\n";
  os << indent << "NumberOfOpenLoops: " << this->GetNumberOfOpenLoops() << "\n";
}
