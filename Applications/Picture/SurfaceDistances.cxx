// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDistances.h"

#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bonedecimate
{
vtkSmartPointer<vtkPolyData> TrianglesOnly(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkCleanPolyData> used;
  used->SetInputConnection(triangles->GetOutputPort());
  used->PointMergingOff();
  used->ConvertPolysToLinesOff();
  used->ConvertLinesToPointsOff();
  used->Update();
  return used->GetOutput();
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
