// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VtkSurfaces.h"

#include "BruteForce.h"
#include "Shapes.h"

#include "vtkCellArray.h"
#include "vtkCellLocator.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double Radius = 10.0; // mm

vtkIdType NumberOfEdges(vtkPolyData* polyData, bool nonManifold)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(polyData);
  edges->SetBoundaryEdges(!nonManifold);
  edges->SetNonManifoldEdges(nonManifold);
  edges->SetFeatureEdges(false);
  edges->SetManifoldEdges(false);
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PolyData(const Surface& surface, int pointType)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (const Vector3& point : surface.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const Triangle& corners : surface.Triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetPolys(triangles);
  return polyData;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Sphere(int levels)
{
  return PolyData(Icosphere(levels, Radius));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Bumps(int levels)
{
  return PolyData(BumpySphere(levels, Radius, 0.05, 7));
}

//------------------------------------------------------------------------------
Surface SurfaceOf(vtkPolyData* polyData)
{
  Surface surface;
  surface.Points.resize(static_cast<std::size_t>(polyData->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < polyData->GetNumberOfPoints(); ++p)
  {
    polyData->GetPoint(p, surface.Points[static_cast<std::size_t>(p)].data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < polyData->GetNumberOfPolys(); ++t)
  {
    polyData->GetPolys()->GetCellAtId(t, ids);
    const auto corner = [&](vtkIdType i)
    { return i < ids->GetNumberOfIds() ? static_cast<Index>(ids->GetId(i)) : None; };
    surface.Triangles.push_back({ corner(0), corner(1), corner(2) });
  }
  return surface;
}

//------------------------------------------------------------------------------
std::vector<double> Values(vtkPolyData* polyData, const std::string& arrayName)
{
  vtkDataArray* array = polyData->GetPointData()->GetArray(arrayName.c_str());
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double Largest(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

//------------------------------------------------------------------------------
std::vector<double> LocatorDistances(const std::vector<Vector3>& points, vtkPolyData* surface)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> distances;
  for (const Vector3& point : points)
  {
    double closest[3];
    vtkIdType cellId = -1;
    int subId = 0;
    double squared = 0.0;
    locator->FindClosestPoint(point.data(), closest, cell, cellId, subId, squared);
    distances.push_back(std::sqrt(squared));
  }
  return distances;
}

std::vector<double> LocatorDistances(vtkPolyData* from, vtkPolyData* to)
{
  return LocatorDistances(SurfaceOf(from).Points, to);
}

//------------------------------------------------------------------------------
VtkCounts CountWithVtk(vtkPolyData* polyData)
{
  vtkNew<vtkPolyDataConnectivityFilter> components;
  components->SetInputData(polyData);
  components->SetExtractionModeToAllRegions();
  components->Update();
  return { NumberOfEdges(polyData, false), NumberOfEdges(polyData, true),
    components->GetNumberOfExtractedRegions() };
}

//------------------------------------------------------------------------------
std::string WhatIsWrongWith(vtkPolyData* polyData)
{
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells : { polyData->GetVerts(), polyData->GetLines(), polyData->GetStrips() })
  {
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    {
      cells->GetCellAtId(c, ids);
      vtkIdType* const end = ids->begin() + ids->GetNumberOfIds();
      const bool exist = std::all_of(ids->begin(), end,
        [&](vtkIdType id) { return id >= 0 && id < polyData->GetNumberOfPoints(); });
      if (!exist)
      {
        return "cell " + std::to_string(c) + " names a point that is not there";
      }
    }
  }
  return WhatIsWrong(SurfaceOf(polyData));
}
}
