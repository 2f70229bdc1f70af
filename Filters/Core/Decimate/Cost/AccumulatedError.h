// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AccumulatedError.h
 * @brief The distance between the surfaces before and after a collapse, in both directions, added
 * to what earlier collapses left.
 *
 *     D = max( Dv + d(v, new), Dw + d(w, new), max(Dv, Dw) + d(x, old) )
 *
 *     v, w       ends of the edge, with their accumulated errors Dv and Dw
 *     x          merged vertex
 *     old, new   triangles at both ends before the collapse, and those at x after it
 *     d          distance of a point to the nearest of these triangles
 *
 * D is an estimate along the collapses, not a bound of the distance to the original. This is the
 * scalar reference of Kernels::AccumulateError, which gives the same bits.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_AccumulatedError_h
#define BoneDecimate_Core_Decimate_Cost_AccumulatedError_h

#include "Geometry/Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// An edge and the triangles that its collapse changes; all coordinates in mm.
struct CollapsedEdge
{
  using Corners = std::array<Vector3, 3>;
  Vector3 Start, End;
  Vector3 Merged;              ///< Position of the merged vertex.
  std::vector<Corners> Before; ///< Triangles at both ends.
  std::vector<Corners> After;  ///< Triangles at the merged vertex.
};

/// The accumulated error of the merged vertex, mm. @param atStart,atEnd Those of both ends, mm.
double AccumulatedError(const CollapsedEdge& edge, double atStart, double atEnd);
}

#endif
