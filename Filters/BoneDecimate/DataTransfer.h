// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DataTransfer.h
 * @brief Arrays of the input at the positions of the result's points and cells.
 *
 *     point, not moved            the tuple of its input point
 *     point, floating values      blended in the nearest input triangle, where the point is nearest
 *                                 to it; normals get
 *                                 their length back
 *     point, anything else        the tuple of the nearest input point: ids, labels, text and bits
 *                                 are never blended
 *     triangle                    the tuple of the input cell nearest to its centroid
 *     vertices, lines             their own tuples
 *
 * Nothing is blended along the collapses: each value is that of one position on the input.
 */
#ifndef DataTransfer_h
#define DataTransfer_h

#include "PassedCells.h"
#include "SurfaceConversion.h"

#include <set>
#include <string>

class vtkPolyData;

namespace bonedecimate
{
/// Names of point arrays that are not those of the input in the result.
struct ArrayNames
{
  /// Arrays that the run adds: see PassedNames.h for arrays of the input that have them.
  std::set<std::string> Own;
  std::set<std::string> LeftOut; ///< Arrays of the input that the result does not get.
};

/**
 * Every array of points and cells, with its components, information and attribute, but maps of an
 * earlier run, which do not describe this one.
 */
void TransferArrays(const Result& result, const ConvertedSurface& converted,
  const PassedIds& passed, const ArrayNames& names, vtkPolyData* input, vtkPolyData* output);

/// Point data OriginalPointIds (the nearest input point) and cell data OriginalCellIds.
void AddMaps(const Result& result, const ConvertedSurface& converted, const PassedIds& passed,
  vtkPolyData* output);

/// Point data ResultPointIds: of each input point the output point that it became part of, -1 if no
/// triangle uses it.
void AddInputMap(const Result& result, vtkPolyData* inputCopy);

/// Point normals of the result from its own triangles, instead of those of the input.
void RecomputeNormals(vtkPolyData* output);
}

#endif
