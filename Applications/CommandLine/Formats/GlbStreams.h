// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GlbStreams.h
 * @brief What a GLB file has of each point: position, normal, texture coordinates, color.
 */
#ifndef BoneDecimate_Applications_GlbStreams_h
#define BoneDecimate_Applications_GlbStreams_h

#include "FileParts.h"
#include "MeshoptStreams.h"
#include "PointGrid.h"

#include "vtkPolyData.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
/// An attribute of the points of a part.
struct GlbAttribute
{
  std::string Name;      ///< POSITION and so on.
  int ComponentType = 0; ///< Component type of glTF.
  int Components = 3;
  bool IsNormalized = false;
  PointStream Stream;
  std::vector<double> Least; ///< By component; of positions only.
  std::vector<double> Most;
};

/// @param grid Positions are its whole numbers; none: single precision.
std::vector<GlbAttribute> AttributesOf(
  vtkPolyData* surface, const FilePart& part, const std::optional<PointGrid>& grid);

/// Converts a byte of sRGB to linear color, 0 to 1: factors and vertex colors of glTF are linear.
double LinearColor(unsigned char byte);
}

#endif
