// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelArrays.h
 * @brief Labels of triangles from an array of cells or points.
 *
 *     cell array:    the tuple of the triangle's cell; several components are one label together
 *                    (BoundaryLabels of surface nets)
 *     point array:   the tuple of two of the triangle's corners, or the least of three different
 *                    ones
 *
 * Tuples are numbers in ascending order; the name of (3, 7) is "3_7".
 */
#ifndef LabelArrays_h
#define LabelArrays_h

#include "Run/Input/Labels.h"
#include "SurfaceConversion.h"

#include "vtkSmartPointer.h"

#include <optional>

class vtkDataArray;
class vtkPolyData;

namespace bonedecimate
{
/// Nothing if the array is null or has other values than whole numbers.
/// @param association One of vtkDataObject::FieldAssociations: points or cells.
std::optional<Labels> ReadLabels(
  vtkPolyData* input, const ConvertedSurface& converted, vtkDataArray* array, int association);

/// For each cell the tuple that is its label, of a triangle as above; zeros for vertices and lines.
/// Null as above.
vtkSmartPointer<vtkDataArray> LabelsOfCells(
  vtkPolyData* input, const ConvertedSurface& converted, vtkDataArray* array, int association);
}

#endif
