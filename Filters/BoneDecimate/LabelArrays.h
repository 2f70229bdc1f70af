// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelArrays.h
 * @brief Labels of triangles from an array of cells or points.
 *
 *     cell array:    the tuple of the triangle's cell; several components are one label together (BoundaryLabels of surface nets)
 *     point array:   the tuple of two of the triangle's corners, or the least of three different ones
 *
 * Tuples are numbers in ascending order; the name of (3, 7) is "3_7".
 */
#ifndef LabelArrays_h
#define LabelArrays_h

#include "Labels.h"
#include "SurfaceConversion.h"

#include <optional>
#include <string>

class vtkPolyData;

namespace bonedecimate
{
/// Nothing if there is no such array of whole numbers.
std::optional<Labels> ReadLabels(
  vtkPolyData* input, const ConvertedSurface& converted, const std::string& name);
}

#endif
