// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutwardContour.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArrayRange.h"
#include "vtkFlyingEdges3D.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>

namespace bonedecimate::volume
{
namespace
{
/// In mm along the grid's own axes, the first voxel at zero.
vtkSmartPointer<vtkPolyData> GridContour(const Volume& volume, double value)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(volume.Image->GetDimensions());
  const auto& steps = volume.Geometry.Steps;
  grid->SetSpacing(Length(steps[0]), Length(steps[1]), Length(steps[2]));
  grid->GetPointData()->SetScalars(volume.Image->GetPointData()->GetScalars());
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// The grid's axes need not be at right angles in the patient.
vtkSmartPointer<vtkPoints> PatientPoints(vtkPoints* gridPoints, const VolumeGeometry& geometry)
{
  std::array<Vector3, 3> axes = geometry.Steps;
  for (Vector3& axis : axes)
  {
    const double length = Length(axis);
    axis = { { axis[0] / length, axis[1] / length, axis[2] / length } };
  }
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const vtkIdType count = gridPoints->GetNumberOfPoints();
  points->SetNumberOfPoints(count);
  for (vtkIdType id = 0; id < count; ++id)
  {
    Vector3 grid;
    gridPoints->GetPoint(id, grid.data());
    Vector3 patient = geometry.Origin;
    for (std::size_t i = 0; i < 3; ++i)
    {
      patient[i] += grid[0] * axes[0][i] + grid[1] * axes[1][i] + grid[2] * axes[2][i];
    }
    points->SetPoint(id, patient.data());
  }
  return points;
}

vtkSmartPointer<vtkCellArray> TurnedTriangles(vtkCellArray* triangles)
{
  const auto turned = vtkSmartPointer<vtkCellArray>::New();
  turned->AllocateExact(triangles->GetNumberOfCells(), triangles->GetNumberOfConnectivityIds());
  const auto triangle = vtkSmartPointer<vtkCellArrayIterator>::Take(triangles->NewIterator());
  for (triangle->GoToFirstCell(); !triangle->IsDoneWithTraversal(); triangle->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    triangle->GetCurrentCell(size, ids);
    turned->InsertNextCell({ ids[0], ids[2], ids[1] });
  }
  return turned;
}
}

vtkSmartPointer<vtkPolyData> OutwardContour(const Volume& volume, double value)
{
  const vtkSmartPointer<vtkPolyData> grid = GridContour(volume, value);
  const bool isMirrored = Determinant(volume.Geometry) < 0.0;
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(PatientPoints(grid->GetPoints(), volume.Geometry));
  const vtkSmartPointer<vtkCellArray> triangles = grid->GetPolys();
  surface->SetPolys(isMirrored ? TurnedTriangles(triangles) : triangles);
  return surface;
}

vtkIdType CountNotFinite(vtkDataArray* values)
{
  vtkIdType count = 0;
  if (values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE)
  {
    for (const double value : vtk::DataArrayValueRange(values))
    {
      count += std::isfinite(value) ? 0 : 1;
    }
  }
  return count;
}
}
