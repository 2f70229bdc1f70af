// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelVolume.h"

#include "IntensityChecks.h"
#include "VolumeFile.h"
#include "WholeLabels.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace bonedecimate
{
using namespace volume;

namespace
{
/// Largest cosine of the angle between perpendicular axes that a header rounded, as in AreClose().
constexpr double MaxCosine = 1e-3;

/// Largest cosine of the angle between axes of a vtkImageData that count as perpendicular.
constexpr double CosineOfRounding = 1e-6;

double LargestCosineOf(const VolumeGeometry& geometry)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& a = geometry.Steps[i];
    const Vector3& b = geometry.Steps[(i + 1) % 3];
    largest = std::max(largest, std::abs(Dot(a, b)) / (Length(a) * Length(b)));
  }
  return largest;
}

/// The geometry with the nearest perpendicular axes. Axes that are perpendicular but for the
/// rounding of doubles, or sheared, are returned as they are.
VolumeGeometry Perpendicular(const VolumeGeometry& geometry)
{
  const double cosine = LargestCosineOf(geometry);
  if (cosine <= CosineOfRounding || cosine > MaxCosine)
  {
    return geometry;
  }
  double axes[3][3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = Length(geometry.Steps[axis]);
    std::transform(geometry.Steps[axis].begin(), geometry.Steps[axis].end(), axes[axis],
      [length](double value) { return value / length; });
  }
  vtkMath::Orthogonalize3x3(axes, axes);
  VolumeGeometry perpendicular = geometry;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Vector3 direction{ { axes[axis][0], axes[axis][1], axes[axis][2] } };
    perpendicular.Steps[axis] = Scaled(direction, Length(geometry.Steps[axis]));
  }
  return perpendicular;
}
}

std::string LabelGridNote(const VolumeGeometry& geometry, const std::array<std::int64_t, 3>& size)
{
  const VolumeGeometry perpendicular = Perpendicular(geometry);
  double largest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Vector3 change = Difference(perpendicular.Steps[axis], geometry.Steps[axis]);
    largest += static_cast<double>(size[axis] - 1) * Length(change);
  }
  if (!(largest > 0.0))
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << "its axes are perpendicular only but for rounding; they are made perpendicular, which "
          "moves no voxel by more than "
       << largest << " mm";
  return text.str();
}

void SetLabelGrid(const VolumeGeometry& given, const LayerPositions& layers, vtkImageData* image)
{
  const VolumeGeometry geometry = Perpendicular(given);
  double spacing[3];
  double direction[9];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = Length(geometry.Steps[axis]);
    for (std::size_t row = 0; row < 3; ++row)
    {
      direction[3 * row + axis] = geometry.Steps[axis][row] / spacing[axis];
    }
  }
  if (!layers.empty())
  {
    vtkNew<vtkDoubleArray> positions;
    positions->SetName("VoxelGridLayers");
    for (const double layer : layers)
    {
      positions->InsertNextValue((layer - layers.front()) * spacing[2]);
    }
    image->GetFieldData()->AddArray(positions);
    spacing[2] *= LeastDistance(layers);
  }
  image->SetOrigin(geometry.Origin.data());
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(direction);
}

LabelVolume ReadLabelVolume(
  const std::string& path, const VoxelSpacing& spacing, const SegmentSelection& selection)
{
  const Volume volume = ReadVolume(path, spacing, selection);
  LabelVolume labels;
  labels.Note = volume.Note;
  labels.Problem = volume.Problem;
  if (labels.Problem.empty())
  {
    const WholeLabels whole = MakeWholeLabels(volume.Image);
    labels.Problem = whole.Problem;
    AppendNote(labels.Note, whole.Note);
  }
  if (labels.Problem.empty())
  {
    labels.Image = volume.Image;
    const int* const size = volume.Image->GetDimensions();
    AppendNote(labels.Note, LabelGridNote(volume.Geometry, { { size[0], size[1], size[2] } }));
    SetLabelGrid(volume.Geometry, volume.Layers, labels.Image);
  }
  return labels;
}
}
