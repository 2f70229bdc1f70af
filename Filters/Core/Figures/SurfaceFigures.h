// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFigures.h
 * @brief Counts, area and volume of a surface.
 */
#ifndef BoneDecimate_Core_Figures_SurfaceFigures_h
#define BoneDecimate_Core_Figures_SurfaceFigures_h

#include "ShapeFigures.h"

#include <cstdint>

namespace bonedecimate
{
struct SurfaceStatistics
{
  std::int64_t Faces = 0;
  std::int64_t Points = 0;           ///< Points used by a triangle.
  std::int64_t Components = 0;       ///< Connected by common points.
  std::int64_t BoundaryEdges = 0;    ///< Edges of exactly one triangle.
  std::int64_t NonManifoldEdges = 0; ///< Edges of three or more triangles.
  std::int64_t EulerNumber = 0;      ///< Points - edges + faces.
  double Area = 0.0;                 ///< mm^2
  double Volume = 0.0; ///< mm^3, signed, by the divergence theorem; meaningful for closed surfaces.
  ShapeStatistics Shape;
};
}

#endif
