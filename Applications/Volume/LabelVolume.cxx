// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelVolume.h"

#include "IntensityChecks.h"
#include "VolumeFile.h"
#include "WholeLabels.h"

#include <cmath>

namespace bonedecimate
{
using namespace volume;

namespace
{
/// Of the cosine of the angle between two axes: that of a vtkImageData counts as perpendicular.
constexpr double LargestCosine = 1e-6;

bool ArePerpendicular(const VolumeGeometry& geometry)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& a = geometry.Steps[i];
    const Vector3& b = geometry.Steps[(i + 1) % 3];
    if (std::abs(Dot(a, b)) > LargestCosine * Length(a) * Length(b))
    {
      return false;
    }
  }
  return true;
}
}

std::string LabelGridProblem(const VolumeGeometry& geometry)
{
  return ArePerpendicular(geometry)
    ? ""
    : "its axes are not perpendicular, which a label map's have to be";
}

void SetLabelGrid(const VolumeGeometry& geometry, vtkImageData* image)
{
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
    labels.Problem = LabelGridProblem(volume.Geometry);
  }
  if (labels.Problem.empty())
  {
    const WholeLabels whole = MakeWholeLabels(volume.Image);
    labels.Problem = whole.Problem;
    AppendNote(labels.Note, whole.Note);
  }
  if (labels.Problem.empty())
  {
    labels.Image = volume.Image;
    SetLabelGrid(volume.Geometry, labels.Image);
  }
  return labels;
}
}
