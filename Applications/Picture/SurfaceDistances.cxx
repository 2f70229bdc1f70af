// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDistances.h"

#include "NamedLabels.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bonedecimate
{
namespace
{
/// The surface without triangles of no area, which the filter leaves out, too. All points remain.
vtkSmartPointer<vtkPolyData> WithArea(vtkPolyData* triangles)
{
  vtkNew<vtkCellArray> kept;
  vtkDataArray* const labels = triangles->GetCellData()->GetArray(LabelsOfSidesName);
  const auto keptLabels =
    vtkSmartPointer<vtkDataArray>::Take(labels ? labels->NewInstance() : nullptr);
  if (labels)
  {
    keptLabels->SetName(LabelsOfSidesName);
    keptLabels->SetNumberOfComponents(labels->GetNumberOfComponents());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfPolys(); ++cell)
  {
    triangles->GetPolys()->GetCellAtId(cell, corners);
    std::array<std::array<double, 3>, 3> positions;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      triangles->GetPoint(corners->GetId(i), positions[static_cast<std::size_t>(i)].data());
    }
    if (vtkTriangle::TriangleArea(positions[0].data(), positions[1].data(), positions[2].data()) >
      0.0)
    {
      kept->InsertNextCell(corners);
      if (labels)
      {
        keptLabels->InsertNextTuple(cell, labels);
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(triangles->GetPoints());
  result->SetPolys(kept);
  result->GetPointData()->ShallowCopy(triangles->GetPointData());
  if (labels)
  {
    result->GetCellData()->AddArray(keptLabels);
  }
  return result;
}
}

vtkSmartPointer<vtkPolyData> TrianglesOnly(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkNew<vtkCleanPolyData> used;
  used->SetInputData(WithArea(triangles->GetOutput()));
  used->PointMergingOff();
  used->ConvertPolysToLinesOff();
  used->ConvertLinesToPointsOff();
  used->Update();
  return used->GetOutput();
}

vtkSmartPointer<vtkPolyData> MergedTriangles(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(TrianglesOnly(surface));
  merged->SetTolerance(0.0);
  merged->ConvertPolysToLinesOff();
  merged->ConvertLinesToPointsOff();
  merged->Update();
  return merged->GetOutput();
}

std::vector<double> SortedDistances(vtkPolyData* triangles, const std::string& arrayName)
{
  vtkDataArray* distances = triangles->GetPointData()->GetArray(arrayName.c_str());
  const vtkIdType count = distances ? distances->GetNumberOfTuples() : 0;
  std::vector<double> sorted;
  sorted.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double distance = distances->GetComponent(i, 0);
    if (std::isfinite(distance))
    {
      sorted.push_back(distance);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double Quantile(const std::vector<double>& sorted, double fraction)
{
  if (sorted.empty())
  {
    return 0.0;
  }
  const double rank = std::ceil(fraction * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}
}
