// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellGeometry.h
 * @brief Corners, edges and faces of a cell, the cube between eight voxel centers.
 *
 * Bits 0, 1 and 2 of a corner are its x, y and z. Edges 0-3 run along x, 4-7 along y, 8-11 along z.
 * Faces 0 and 1 are perpendicular to x, 2 and 3 to y, 4 and 5 to z, the lower one first.
 *
 * Points of a surface in a cell: 0-11 are the midpoints of edges, 12-17 points on faces, from 18 on
 * points inside.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_CellGeometry_h
#define BoneDecimate_Core_Labels_LabelMap_CellGeometry_h

#include "Geometry/Surface.h"

#include <array>
#include <cstddef>

namespace bonedecimate
{
constexpr int NumberOfCellEdges = 12;
constexpr int NumberOfCellFaces = 6;
constexpr int FirstFacePoint = NumberOfCellEdges;
constexpr int FirstInnerPoint = FirstFacePoint + NumberOfCellFaces;

template <typename Value, std::size_t Rows, std::size_t Columns>
using CellTable = std::array<std::array<Value, Columns>, Rows>;

/// The lower corner first.
constexpr CellTable<int, 12, 2> EdgeCorners = { { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 2 },
  { 1, 3 }, { 4, 6 }, { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };

/// Counter-clockwise seen from outside.
constexpr CellTable<int, 6, 4> FaceCorners = { { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
  { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } } };

namespace celltables
{
constexpr std::size_t EdgeBetween(int a, int b)
{
  for (std::size_t edge = 0; edge < EdgeCorners.size(); ++edge)
  {
    const auto& ends = EdgeCorners[edge];
    if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
    {
      return edge;
    }
  }
  return EdgeCorners.size();
}

constexpr CellTable<int, 6, 4> MakeFaceEdges()
{
  CellTable<int, 6, 4> edges = {};
  for (std::size_t face = 0; face < edges.size(); ++face)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const auto& corners = FaceCorners[face];
      edges[face][k] = static_cast<int>(EdgeBetween(corners[k], corners[(k + 1) % 4]));
    }
  }
  return edges;
}

constexpr bool LiesOnFace(int point, std::size_t face, const CellTable<int, 6, 4>& faceEdges)
{
  bool liesOnFace = point == FirstFacePoint + static_cast<int>(face);
  for (const int edge : faceEdges[face])
  {
    liesOnFace = liesOnFace || edge == point;
  }
  return liesOnFace;
}

constexpr CellTable<bool, 18, 18> MakeOnOneFace()
{
  CellTable<bool, 18, 18> onOneFace = {};
  const CellTable<int, 6, 4> faceEdges = MakeFaceEdges();
  for (std::size_t a = 0; a < onOneFace.size(); ++a)
  {
    for (std::size_t b = 0; b < onOneFace.size(); ++b)
    {
      for (std::size_t face = 0; face < faceEdges.size(); ++face)
      {
        onOneFace[a][b] = onOneFace[a][b] ||
          (LiesOnFace(static_cast<int>(a), face, faceEdges) &&
            LiesOnFace(static_cast<int>(b), face, faceEdges));
      }
    }
  }
  return onOneFace;
}
}

/// Edge k of a face runs from its corner k to the next one.
constexpr CellTable<int, 6, 4> FaceEdges = celltables::MakeFaceEdges();

/// Whether two points on edges or faces of the cell lie on one face.
constexpr CellTable<bool, 18, 18> OnOneFace = celltables::MakeOnOneFace();

/// In voxels, in a cell from 0 to 1.
inline Vector3 CellCorner(int corner)
{
  return { static_cast<double>(corner & 1), static_cast<double>(corner >> 1 & 1),
    static_cast<double>(corner >> 2 & 1) };
}

inline Vector3 MiddleOfEdge(int edge)
{
  const auto& ends = EdgeCorners[static_cast<std::size_t>(edge)];
  return 0.5 * (CellCorner(ends[0]) + CellCorner(ends[1]));
}
}

#endif
