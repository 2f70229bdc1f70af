// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AccumulatedError.h
 * @brief How far a collapse leaves the surface behind, with what earlier collapses left behind,
 * both ways.
 *
 *     D = max( Dv + d(v, new), Dw + d(w, new), max(Dv, Dw) + d(x, old) )
 *
 * v and w are the ends of the edge with their accumulated errors Dv and Dw, x is the merged vertex,
 * old the triangles at both ends before the collapse, new those at x after it, d the distance of a
 * point to the nearest of them. D is an estimate along the collapses, not a bound of the distance
 * to the original.
 *
 * This is the scalar reference of Kernels::AccumulateError, which gives the same bits.
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

/// mm.  @param atStart,atEnd Accumulated errors of both ends, mm.
double AccumulatedError(const CollapsedEdge& edge, double atStart, double atEnd);
}

#endif
