// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelStack.h
 * @brief All levels of a recorded run in arrays from which each can be extracted without replaying
 * its edits.
 *
 *     each face     time of its removal; a linked list of the changes of its corners by flips,
 *                   latest first
 *     each vertex   time of its removal and the vertex into which it was merged; all its
 *                   positions with times
 *
 *     level t:  the faces removed later, in their order
 *               corners: after the last change up to t, each replaced by the vertex into which
 *                 it was merged up to t
 *               points:  the last position up to t
 *
 * Time counts collapses: collapse 0 happens at time 1, a patch at the number of collapses before
 * it. After H. Hoppe, Progressive meshes, SIGGRAPH 1996, with times instead of a sequence.
 */
#ifndef BoneDecimate_Core_Levels_LevelStack_h
#define BoneDecimate_Core_Levels_LevelStack_h

#include "Base/LargeArray.h"
#include "EditLog.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
struct Level
{
  bonedecimate::Surface Surface; ///< mm, in the input's frame.
  std::vector<Index> Vertices;   ///< For each point its vertex of the cleaned input.
};

class LevelStack
{
public:
  /**
   * Replays the log once and validates all its values.
   * @param triangles The triangles of the cleaned and sorted input.
   * @return Empty if the log cannot belong to that surface.
   */
  static std::optional<LevelStack> Build(
    const std::vector<Triangle>& triangles, const EditLog& log);

  Index NumberOfCollapses() const { return static_cast<Index>(this->FacesLeft.size()) - 1; }
  /// Number of triangles of the level after that many collapses.
  Index TrianglesAt(Index collapses) const
  {
    return this->FacesLeft[static_cast<std::size_t>(collapses)];
  }
  /// The first level with at most that many triangles; the last level if there is none.
  Index LevelOf(Index triangles) const;
  /// For each triangle of At(), the triangle of the cleaned input that it was.
  std::vector<Index> FacesAt(Index collapses) const;

  /// @param points Positions of the cleaned input's vertices, mm, in the frame of the input; used
  ///   for vertices that never moved.
  /// @param originals The original vertex of each vertex (ManifoldPatches.h); empty: nothing was
  ///   split.
  Level At(Index collapses, int threads, const std::vector<Vector3>& points,
    const std::vector<Index>& originals) const;

private:
  struct VertexLife
  {
    Index End = Never;       // time
    Index MergedInto = None; // a vertex
  };
  struct TimedPosition
  {
    Vector3 Position; // mm
    Index Time;
    Index Vertex;
  };
  struct Change
  {
    Triangle Corners;
    Index Time;
    Index Previous;
  };
  static constexpr Index Never = std::numeric_limits<Index>::max();
  class Builder;

  Index VertexAt(Index vertex, Index time) const
  {
    while (this->VertexLives[vertex].End <= time)
    {
      vertex = this->VertexLives[vertex].MergedInto;
    }
    return vertex;
  }
  Triangle CornersAt(Index face, Index time) const;
  /// The last position that an edit set up to this time; null: none.
  const Vector3* PositionAt(Index vertex, Index time) const;

  std::vector<Triangle> Corners; // of each face in the input
  std::vector<Index> FaceEnds;   // time
  std::vector<Index> LastChange; // of each face
  std::vector<Change> Changes;
  LargeArray<VertexLife> VertexLives;
  std::vector<TimedPosition> TimedPositions; // sorted by vertex, then by time
  std::vector<Index> FirstPositions;         // for each vertex, and finally their number
  std::vector<Index> FacesLeft;              // at each time
};
}

#endif
