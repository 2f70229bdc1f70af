// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FastLoop.h
 * @brief Collapses ordered by what they do to the normal field, level by level, each edge judged in O(1).
 *
 *     put every vertex on the level of its cheapest edge
 *     while the goal is not reached:
 *         v = first vertex of the lowest level; judge its edges afresh, cheapest first:
 *         dearer than the level:  v goes to the level of that edge
 *         refused by the gate:    the next edge; after the last, v comes again when costs are 16 times higher
 *         else collapse; sum the quadrics of the merged vertex and its ring afresh; put the merged vertex on its level
 *     levels empty: fill them once more, unless nothing has been collapsed since
 *
 * Neighbours keep their level although their costs changed: they are judged afresh when their turn comes. Below a fiftieth
 * of the input that is not good enough, and their levels are renewed at once.
 */
#ifndef BoneDecimate_Core_Collapse_FastLoop_h
#define BoneDecimate_Core_Collapse_FastLoop_h

#include "Cost/VertexQuadrics.h"
#include "Editor.h"
#include "Goal.h"
#include "LevelQueue.h"

namespace bonedecimate
{
class FastLoop
{
public:
  FastLoop(Editor& editor, const Stops& stops);

  /// @param monitor Hears fractions from 0 to 1.
  StopReason Run(const Monitor& monitor);

private:
  struct Candidate
  {
    VertexQuadrics::Answer Answer;
    Index Edge = None;
  };
  void Fill();
  void FindCandidates(Index vertex);
  void PutOnLevel(Index vertex);
  void CollapseAt(const LevelQueue::Entry& entry);
  bool CollapseEdge(const Candidate& candidate);
  Edit EditOf(const Candidate& candidate) const;
  double DistanceToFan(const Vector3& p, Index vertex) const;

  Editor& Work;
  Goal End;
  VertexQuadrics Quadrics;
  LevelQueue Queue;
  std::vector<Candidate> Candidates;
  Index RenewBelow;
};
}

#endif
