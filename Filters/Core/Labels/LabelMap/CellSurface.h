// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSurface.h
 * @brief The surface between the labels at the eight corners of a cell.
 *
 * The curves in which it meets the faces of the cell depend only on the labels of the face, so the
 * surfaces of neighboring cells fit together. Labels are ranks (LabelRanks.h): 0 is the background.
 * On a face with the labels a0 to a3 in cyclic order:
 *
 *     two edges with different ends      a segment from one to the other
 *     ABAC                               B and C are cut off by a segment each
 *     ABAB                               the larger rank is cut off at both corners, so
 *                                        the background stays connected
 *     three or four labels otherwise     a point on the face, at the mean of the midpoints of
 *                                        its edges with different ends, and a segment to each
 *
 * Connected segments of a cell bound one part of its surface:
 *
 *     no point on a face                        one polygon between two labels
 *     two points on faces, three segments each  three polygons with a common edge
 *                                               between these points
 *     else                                      a cone to the mean of the points on faces
 *
 * Polygons get no diagonal in a face of the cell, where the neighboring cell might have the same
 * one.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_CellSurface_h
#define BoneDecimate_Core_Labels_LabelMap_CellSurface_h

#include "CellGeometry.h"
#include "Geometry/Surface.h"

#include <array>
#include <cstddef>

namespace bonedecimate
{
/// The ranks of the labels at the eight corners.
using CellLabels = std::array<Index, 8>;

/// The normal points from the first label to the second.
struct CellTriangle
{
  std::array<int, 3> Points; ///< See CellGeometry.h.
  Index From;
  Index To;
};

class CellSurface
{
public:
  CellSurface();

  void Clear();
  void Add(const CellTriangle& triangle) { this->Triangles[this->Size++] = triangle; }
  /// Returns the number of the new point.
  int AddInnerPoint(const Vector3& position);
  void SetFacePoint(int point, const Vector3& position);

  const CellTriangle* begin() const { return this->Triangles.data(); }
  const CellTriangle* end() const { return this->Triangles.data() + this->Size; }
  std::size_t NumberOfTriangles() const { return this->Size; }
  std::size_t NumberOfInnerPoints() const { return this->InnerPoints; }
  /// Position of a point of the surface in voxels, in a cell from 0 to 1.
  const Vector3& Position(int point) const
  {
    return this->Positions[static_cast<std::size_t>(point)];
  }

private:
  // Each of four segments on six faces has at most one triangle, and each inner point needs a face
  // of its own.
  std::array<CellTriangle, 24> Triangles = {};
  std::array<Vector3, FirstInnerPoint + NumberOfCellFaces> Positions;
  std::size_t Size = 0;
  std::size_t InnerPoints = 0;
};

/// Whether a face with these labels around it has a point on it.
inline bool HasFacePoint(Index a, Index b, Index c, Index d)
{
  const int changes = (a != b) + (b != c) + (c != d) + (d != a);
  return changes == 3 || (changes == 4 && a != c && b != d);
}

/// Replaces the surface by that of the labels.
void BuildCellSurface(const CellLabels& labels, CellSurface& surface);

/**
 * The surfaces of cells with two labels: bit c of the index is set if corner c has the larger rank.
 * The labels of their triangles are 0 for the smaller rank and 1 for the larger.
 */
const std::array<CellSurface, 256>& TwoLabelSurfaces();
}

#endif
