// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutwardContour.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bonedecimate::volume
{
namespace
{
/// In mm along the grid's own axes, the first voxel at zero.
vtkSmartPointer<vtkPolyData> GridContour(const Volume& volume, double value)
{
  vtkNew<vtkImageData> grid;
  grid->SetExtent(volume.Image->GetExtent());
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

/// Linear between two layers, as values are.
double PositionOf(double layer, const LayerPositions& layers)
{
  const double last = static_cast<double>(layers.size()) - 2.0;
  const double below = std::clamp(std::floor(layer), 0.0, last);
  const auto k = static_cast<std::size_t>(below);
  return layers[k] + (layer - below) * (layers[k + 1] - layers[k]);
}

/// The grid's axes need not be at right angles in the patient, and its layers not evenly spaced.
vtkSmartPointer<vtkPoints> PatientPoints(
  vtkPoints* gridPoints, const VolumeGeometry& geometry, const LayerPositions& layers)
{
  const double step = Length(geometry.Steps[2]);
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
    grid[2] = layers.empty() ? grid[2] : step * PositionOf(grid[2] / step, layers);
    Vector3 patient = geometry.Origin;
    for (std::size_t i = 0; i < 3; ++i)
    {
      patient[i] += grid[0] * axes[0][i] + grid[1] * axes[1][i] + grid[2] * axes[2][i];
    }
    points->SetPoint(id, patient.data());
  }
  return points;
}

/// Counts the edges of the grid that a contour crosses: its points.
class CrossingCounter
{
public:
  CrossingCounter(int width, int height, double value)
    : Width(static_cast<std::size_t>(width))
    , Size(this->Width * static_cast<std::size_t>(height))
    , Value(value)
    , IsInside(this->Size)
    , WasInside(this->Size)
  {
  }

  template <typename Scalar>
  std::vector<std::int64_t> Count(const Scalar* values, int layers)
  {
    std::vector<std::int64_t> counts;
    for (int layer = 0; layer < layers; ++layer, values += this->Size)
    {
      std::swap(this->IsInside, this->WasInside);
      std::transform(values, values + this->Size, this->IsInside.begin(),
        [this](Scalar value) { return static_cast<double>(value) >= this->Value ? 1 : 0; });
      if (layer > 0)
      {
        counts.back() += this->CountBetween();
      }
      counts.push_back(this->CountInLayer());
    }
    return counts;
  }

private:
  using Flags = std::vector<unsigned char>;

  /// Counts the flags that differ between two rows.
  static std::int64_t CountDifferent(
    const unsigned char* a, const unsigned char* b, std::size_t count)
  {
    std::uint32_t different = 0; // 32 bits, so that the loop is vectorized
    for (std::size_t i = 0; i < count; ++i)
    {
      different += static_cast<std::uint32_t>(a[i] ^ b[i]);
    }
    return different;
  }

  std::int64_t CountBetween() const
  {
    std::int64_t count = 0;
    for (std::size_t row = 0; row < this->Size; row += this->Width)
    {
      count +=
        CountDifferent(this->IsInside.data() + row, this->WasInside.data() + row, this->Width);
    }
    return count;
  }

  std::int64_t CountInLayer() const
  {
    std::int64_t count = 0;
    for (std::size_t row = 0; row < this->Size; row += this->Width)
    {
      const unsigned char* const flags = this->IsInside.data() + row;
      count += CountDifferent(flags, flags + 1, this->Width - 1);
      count += row > 0 ? CountDifferent(flags, flags - this->Width, this->Width) : 0;
    }
    return count;
  }

  std::size_t Width;
  std::size_t Size;
  double Value;
  Flags IsInside;
  Flags WasInside; // the layer before
};

/// Without those of two equal corners: where a voxel has the very value, several edges of the grid
/// are cut in it.
vtkSmartPointer<vtkCellArray> TrianglesOf(vtkCellArray* found, vtkPoints* points, bool areTurned)
{
  const auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->AllocateEstimate(found->GetNumberOfCells(), 3);
  const auto triangle = vtkSmartPointer<vtkCellArrayIterator>::Take(found->NewIterator());
  for (triangle->GoToFirstCell(); !triangle->IsDoneWithTraversal(); triangle->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    triangle->GetCurrentCell(size, ids);
    std::array<Vector3, 3> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      points->GetPoint(ids[k], corners[k].data());
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      triangles->InsertNextCell({ ids[0], ids[areTurned ? 2 : 1], ids[areTurned ? 1 : 2] });
    }
  }
  return triangles;
}
}

vtkSmartPointer<vtkPolyData> OutwardContour(const Volume& volume, double value)
{
  const vtkSmartPointer<vtkPolyData> grid = GridContour(volume, value);
  const bool isMirrored = Determinant(volume.Geometry) < 0.0;
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(PatientPoints(grid->GetPoints(), volume.Geometry, volume.Layers));
  surface->SetPolys(TrianglesOf(grid->GetPolys(), surface->GetPoints(), isMirrored));
  return surface;
}

std::vector<std::int64_t> CountContourPoints(const Volume& slab, double value)
{
  vtkDataArray* const values = slab.Image->GetPointData()->GetScalars();
  const int* const size = slab.Image->GetDimensions();
  switch (values->GetDataType())
  {
    vtkTemplateMacro(return CrossingCounter(size[0], size[1], value)
        .Count(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), size[2]));
    default:
      return {};
  }
}
}
