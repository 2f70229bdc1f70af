// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Borders.h
 * @brief The open borders of a surface: edges of exactly one triangle, where points of equal coordinates are one point.
 *
 * Triangles that name one point twice have no edges; those of three points in a line have three.
 */
#ifndef BoneDecimate_Core_Certificate_Borders_h
#define BoneDecimate_Core_Certificate_Borders_h

#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate::certificate
{
struct BorderEdge
{
  std::array<Index, 2> Points; ///< as that triangle names them
  Index Triangle = None;
};

/// In the order of the triangles.
std::vector<BorderEdge> FindBorders(const Surface& surface);
}

#endif
