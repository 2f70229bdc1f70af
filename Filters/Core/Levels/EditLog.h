// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditLog.h
 * @brief What a run did to its mesh, in an order of which every beginning is a surface of its own.
 *
 *     collapses   one after the other; level n of a run is what the first n of them made
 *     patches     what flips and moves changed between two collapses, all at once
 *     marks       levels whose distance to the input was measured
 *
 * Ids are those of the cleaned and sorted input (Cleaning.h, SpatialOrder.h), so that the same input makes sense of them
 * again. Positions are those of the output: in the input's frame, mm, of single precision if the output is.
 */
#ifndef BoneDecimate_Core_Levels_EditLog_h
#define BoneDecimate_Core_Levels_EditLog_h

#include "Surface.h"

#include <limits>
#include <vector>

namespace bonedecimate
{
struct LoggedCollapse
{
  Vector3 Position;       ///< Of the merged vertex, mm.
  Index HalfEdge = None;  ///< From one end to the other, in a face that goes; see HalfEdgeMesh.h.
  Index OtherFace = None; ///< The other face that goes; None on a border.
  Index Kept = None;      ///< The end that survives.
  float Rank = 0.0F;      ///< While it is recorded: what it cost, in its loop's unit.
};

/// The state after flips and moves, of what they changed.
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
  Index Collapses = 0; ///< How many there were before.
  std::vector<Face> Faces;
  std::vector<Vertex> Vertices;
};

/// A level by its number of collapses, and how far it is from the input.
struct LevelMark
{
  Index Collapses = 0;
  Index Triangles = 0;
  double Largest = std::numeric_limits<double>::quiet_NaN(); ///< mm, both ways; NaN: not measured.
  double Mean = std::numeric_limits<double>::quiet_NaN();    ///< mm, the larger of both ways.
};

struct EditLog
{
  std::uint64_t InputChecksum = 0; ///< Checksum.h
  Index Vertices = 0;              ///< Of the cleaned input,
  Index Faces = 0;                 ///< of which so many, too.
  bool IsSingle = false;           ///< Precision of the positions and of the output.
  bool MergesPoints = true;        ///< How the input was cleaned.
  std::vector<LoggedCollapse> Collapses;
  std::vector<LoggedPatch> Patches; ///< In the order of their places among the collapses.
  std::vector<LevelMark> Marks;     ///< From fine to coarse.
};
}

#endif
