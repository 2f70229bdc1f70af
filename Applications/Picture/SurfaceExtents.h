// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceExtents.h
 * @brief What a surface consists of: its labels, and the specks among its components.
 */
#ifndef BoneDecimate_Applications_SurfaceExtents_h
#define BoneDecimate_Applications_SurfaceExtents_h

#include "NamedLabels.h"

#include "vtkPolyData.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Specks are components whose bounding box has no side of a fiftieth of the diagonal of the
/// surface, rounded down to one digit: what --prune-size of that size leaves out.
struct SpeckFigures
{
  double Size = 0.0; ///< mm; no speck has a longer side.
  std::int64_t Components = 0;
  std::int64_t Specks = 0;
  double AreaRatio = 0.0; ///< Area of all specks, as a fraction of that of the surface.

  /// Whether there are so many that leaving them out is worth a hint.
  bool AreMany() const { return this->Specks >= 10; }
};

SpeckFigures FindSpecks(vtkPolyData* surface);

/// What one label of a surface with BoundaryLabels encloses. A wall between two labels is of both.
struct LabelExtent
{
  NamedLabel Label;
  std::int64_t Triangles = 0;
  std::int64_t Components = 0; ///< Connected by common points.
  double Area = 0.0;           ///< mm2
  double Volume = 0.0;         ///< mm3; cavities are subtracted.
};

/// One for each of the labels, those without triangles, too. Empty if the surface has no
/// BoundaryLabels.
std::vector<LabelExtent> LabelExtents(vtkPolyData* surface, const std::vector<NamedLabel>& labels);
}

#endif
