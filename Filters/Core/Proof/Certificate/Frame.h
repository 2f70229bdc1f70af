// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Frame.h
 * @brief The local frame of two surfaces, and their simplices in it.
 *
 * Along each axis the coordinate nearest to 0 is subtracted if all have its sign and none is more
 * than twice as far from 0: the difference is then exact (P. H. Sterbenz, Floating-point
 * computation, 1974). Otherwise nothing is subtracted, and no coordinate is farther from 0 than
 * twice the size of both surfaces. Points are equal in the frame if and only if they are equal in
 * the input.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Frame_h
#define BoneDecimate_Core_Proof_Certificate_Frame_h

#include "Geometry/Surface.h"
#include "Simplices.h"

namespace bonedecimate::certificate
{
/// Whether the points of all triangles exist and are usable.
bool HasUsableTriangles(const Surface& surface);

struct Frame
{
  Vector3 Origin = Vector3::Zero(); ///< mm
  double Extent = 0.0;              ///< mm, the largest absolute coordinate in the frame
};

Frame FindFrame(const Surface& reference, const Surface& result);

/// @param sides Edge sides of the surface; kept.
Simplices WholeSurface(const Surface& surface, const EdgeSides& sides, const Frame& frame);

/// The part with finite limits: of each simplex the corners with a finite limit, as a triangle,
/// segment or point.
Simplices LimitedPart(const Simplices& whole, const std::vector<double>& limit);

struct BoundarySet
{
  Simplices Segments;
  std::vector<double> Limit; ///< mm, at each point; empty without a map
};

/// @param sides Edge sides of the surface.
/// @param limit mm, at each point of the surface; may be empty.
BoundarySet FindBoundarySet(const Surface& surface, const EdgeSides& sides, const Frame& frame,
  const std::vector<double>& limit);
}

#endif
