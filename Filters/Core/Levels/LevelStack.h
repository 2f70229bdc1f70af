// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelStack.h
 * @brief All levels of a recorded run in arrays from which each is read off, without its edits being replayed.
 *
 *     each face     when it went; the last time its corners were changed by flips, and from there the time before
 *     each vertex   when it went, and into which; all the times it was placed
 *
 *     level t:  the faces that went later, in their order
 *               corners: as they were changed last by then, each followed into what it had become by then
 *               points:  where they were placed last by then
 *
 * Time counts collapses: collapse 0 happens at time 1, a patch at the number of collapses before it.
 * After H. Hoppe, Progressive meshes, SIGGRAPH 1996, with times in place of a sequence.
 */
#ifndef BoneDecimate_Core_Levels_LevelStack_h
#define BoneDecimate_Core_Levels_LevelStack_h

#include "EditLog.h"
#include "Memory/LargeArray.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
struct Level
{
  bonedecimate::Surface Surface; ///< mm, in the input's frame.
  std::vector<Index> Vertices;   ///< Of each point: its vertex of the cleaned input.
};

class LevelStack
{
public:
  /**
   * Replays the log once, trusting none of its numbers.
   * @param triangles Of the cleaned and sorted input.
   * @return Nothing if the log cannot have been recorded on that surface.
   */
  static std::optional<LevelStack> Build(
    const std::vector<Triangle>& triangles, const EditLog& log);

  Index NumberOfCollapses() const { return static_cast<Index>(this->FacesLeft.size()) - 1; }
  /// Triangles of the level after so many collapses.
  Index TrianglesAt(Index collapses) const
  {
    return this->FacesLeft[static_cast<std::size_t>(collapses)];
  }
  /// The first level of no more triangles than that; the last one if there is none.
  Index LevelOf(Index triangles) const;

  /// @param points Of the cleaned input's vertices, mm, in the input's frame: of those that no edit placed.
  /// @param sites Of each vertex, see Sheets.h; empty: there is one sheet.
  Level At(Index collapses, int threads, const std::vector<Vector3>& points,
    const std::vector<Index>& sites) const;

private:
  struct Life
  {
    Index End = Never; // time
    Index Into = None; // a vertex
  };
  struct Placing
  {
    Vector3 Position; // mm
    Index Time;
    Index Vertex;
  };
  struct Change
  {
    Triangle Corners;
    Index Time;
    Index Before;
  };
  static constexpr Index Never = std::numeric_limits<Index>::max();
  class Builder;

  Index VertexAt(Index vertex, Index time) const
  {
    while (this->Lives[vertex].End <= time)
    {
      vertex = this->Lives[vertex].Into;
    }
    return vertex;
  }
  Triangle CornersAt(Index face, Index time) const;
  /// Where an edit placed it last by then; null: none did.
  const Vector3* PlaceAt(Index vertex, Index time) const;

  std::vector<Triangle> Corners; // of each face at first
  std::vector<Index> FaceEnds;   // time
  std::vector<Index> LastChange; // of each face
  std::vector<Change> Changes;
  LargeArray<Life> Lives;
  std::vector<Placing> Placings;   // vertex after vertex, of each in the order of time
  std::vector<Index> FirstPlacing; // of each vertex, and at the end how many there are
  std::vector<Index> FacesLeft;    // of each time
};
}

#endif
