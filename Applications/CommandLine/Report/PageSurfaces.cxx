// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PageSurfaces.h"

#include "SurfaceDistances.h"
#include "Terminal/VtkMessages.h"

#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"

#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Without the triangles whose corners became no point of the result.
vtkSmartPointer<vtkPolyData> WithoutPruned(vtkPolyData* copy, const char* resultPoints)
{
  auto triangles = TrianglesOnly(copy);
  vtkDataArray* const points = triangles->GetPointData()->GetArray(resultPoints);
  triangles->BuildCells();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellPoints(cell, corners);
    if (points->GetComponent(corners->GetId(0), 0) < 0.0)
    {
      triangles->DeleteCell(cell);
    }
  }
  triangles->RemoveDeletedCells();
  return triangles;
}
}

vtkSmartPointer<vtkPolyData> SurfaceBefore(vtkBoneDecimate* filter)
{
  vtkPolyData* const copy = filter->GetOutput(1);
  // Without pruning the array would be that of an earlier run.
  const char* const resultPoints = "ResultPointIds";
  if (filter->GetReportValue("pruned.triangles") > 0.0 &&
    copy->GetPointData()->HasArray(resultPoints))
  {
    return WithoutPruned(copy, resultPoints);
  }
  return copy;
}

PageSubject PageOfRun(vtkBoneDecimate* filter)
{
  PageSubject page;
  page.Result = filter->GetOutput();
  page.Before = SurfaceBefore(filter);
  page.DistanceArrayName = filter->GetInputDistanceArrayName();
  page.ResultDistanceArrayName = filter->GetDistanceArrayName();
  page.Reduce = ReduceForPage;
  return page;
}

vtkSmartPointer<vtkPolyData> ReduceForPage(vtkPolyData* surface, vtkIdType triangles)
{
  vtkNew<vtkBoneDecimate> filter;
  filter->SetInputData(surface);
  filter->SetModeToFast();
  filter->SetTargetNumberOfTriangles(static_cast<int>(triangles));
  filter->SetMeasureDistances(false);
  filter->SetPassArrays(true);
  filter->Update();
  TakeVtkMessages(); // the run of the result has told them
  vtkPolyData* const reduced = filter->GetOutput();
  return reduced->GetNumberOfPolys() > 0 ? reduced : surface;
}

vtkSmartPointer<vtkPolyData> WithoutSigns(
  vtkPolyData* surface, const std::string& signedName, const std::string& arrayName)
{
  vtkDataArray* const signs = surface->GetPointData()->GetArray(signedName.c_str());
  if (signs == nullptr)
  {
    return surface;
  }
  vtkNew<vtkFloatArray> distances;
  distances->SetName(arrayName.c_str());
  for (vtkIdType point = 0; point < signs->GetNumberOfTuples(); ++point)
  {
    distances->InsertNextValue(static_cast<float>(std::abs(signs->GetComponent(point, 0))));
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->GetPointData()->AddArray(distances);
  return result;
}

vtkSmartPointer<vtkPolyData> WithDistances(
  vtkPolyData* surface, vtkPolyData* other, const std::string& arrayName)
{
  vtkNew<vtkStaticCellLocator> locator;
  const auto triangles = TrianglesOnly(other);
  locator->SetDataSet(triangles);
  locator->BuildLocator();
  vtkNew<vtkFloatArray> distances;
  distances->SetName(arrayName.c_str());
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    std::array<double, 3> closest;
    vtkIdType triangle = 0;
    int subId = 0;
    double squared = 0.0;
    locator->FindClosestPoint(
      surface->GetPoint(point), closest.data(), cell, triangle, subId, squared);
    distances->InsertNextValue(static_cast<float>(std::sqrt(squared)));
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->GetPointData()->AddArray(distances);
  return result;
}
}
