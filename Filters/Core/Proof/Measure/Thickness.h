// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Thickness.h
 * @brief The thickness of a part before and after, along the same directions.
 *
 *     direction      from a sample of the result against the normal of its triangle; normals of
 *                    the input are far off at the steps of a staircase
 *     after          from the sample to the first triangle through which the line leaves the part
 *     before         the same from the nearest point at which the line may enter the input
 *
 * Lines that do not leave one of the surfaces, for example through a boundary, are left out.
 */
#ifndef BoneDecimate_Core_Proof_Measure_Thickness_h
#define BoneDecimate_Core_Proof_Measure_Thickness_h

#include "Figures/PartFigures.h"
#include "Geometry/BoundingTree.h"
#include "Geometry/Surface.h"
#include "Mesh/SurfaceParts.h"

#include <vector>

namespace bonedecimate
{
/// A surface and the parts on both sides of its triangles.
struct SolidSurface
{
  const bonedecimate::Surface& Surface;
  const BoundingTree& Tree; ///< Bounding tree of the surface.
  /// Parts at each triangle; null: all normals point out of the one solid 0.
  const std::vector<PartSides>* Sides;
};

struct ThicknessChange
{
  ThicknessFigures Before, After;
};

/// @param triangles The surface of the part in the result, normals outward.
/// @param solid The part, as in the sides.
ThicknessChange CompareThickness(const SolidSurface& before, const SolidSurface& after,
  const std::vector<Triangle>& triangles, Index solid, std::size_t samples, int threads);
}

#endif
