// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditLog.h
 * @brief The edits of a run, in an order in which every prefix gives a valid surface.
 *
 *     collapses   in their order; level n is the surface after the first n of them
 *     patches     all changes by flips and moves between two collapses
 *     marks       levels whose distance to the input was measured
 *
 * Ids are those of the cleaned and sorted input (Cleaning.h, SpatialOrder.h), which can be
 * restored from the same input. Positions are those of the output: in the frame of the input, mm,
 * of single precision if the output is.
 */
#ifndef BoneDecimate_Core_Levels_EditLog_h
#define BoneDecimate_Core_Levels_EditLog_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate
{
struct LoggedCollapse
{
  Vector3 Position;        ///< Position of the merged vertex, mm.
  Index HalfEdge = None;   ///< The collapsed edge, in a removed face; see HalfEdgeMesh.h.
  Index OtherFace = None;  ///< The other removed face; None on a boundary.
  Index KeptVertex = None; ///< The end that is kept.
  float Rank = 0.0F;       ///< Only while recording: the cost, in the unit of its loop.
};

/// The changed faces and vertices after flips and moves.
struct LoggedPatch
{
  struct Face
  {
    Index Id = None;
    Triangle Corners = { None, None, None };
  };
  struct Vertex
  {
    Index Id = None;
    Vector3 Position; ///< mm
  };
  Index Collapses = 0; ///< Number of collapses before the patch.
  std::vector<Face> Faces;
  std::vector<Vertex> Vertices;
};

/// A level by its number of collapses, and its distance to the input.
struct LevelMark
{
  Index Collapses = 0;
  Index Triangles = 0;
  /// mm, the larger direction; NaN: not measured.
  double Largest = std::numeric_limits<double>::quiet_NaN();
  double Mean = std::numeric_limits<double>::quiet_NaN(); ///< mm, the larger direction.
};

struct EditLog
{
  std::uint64_t InputChecksum = 0; ///< Checksum.h
  Index Vertices = 0;              ///< Vertices of the cleaned input.
  Index Faces = 0;                 ///< Faces of the cleaned input.
  bool IsSingle = false;           ///< Whether positions and output have single precision.
  bool MergesPoints = true;        ///< Whether cleaning merged equal points.
  std::vector<LoggedCollapse> Collapses;
  std::vector<LoggedPatch> Patches; ///< In the order of LoggedPatch::Collapses.
  std::vector<LevelMark> Marks;     ///< From fine to coarse.
};
}

#endif
