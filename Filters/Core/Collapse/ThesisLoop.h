// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThesisLoop.h
 * @brief The thesis's loop: lowest vertex, then its lowest edge, until the number or the error is reached.
 *
 *     put every vertex in a queue by its cost
 *     while faces > Faces or maxError < Error:
 *         v = vertex of lowest cost; for its edges e = (v, ve), lowest cost first:
 *             collapse e to the first place that the gate allows; leave
 *         a vertex all of whose edges are refused waits until something around it changes
 *         recompute the costs of the new vertex and its one-ring
 *
 * The new vertex's ring is all that changed: it holds the one-rings of both v and ve.
 */
#ifndef BoneDecimate_Core_Collapse_ThesisLoop_h
#define BoneDecimate_Core_Collapse_ThesisLoop_h

#include "Cost/NormalFieldDeviation.h"
#include "Editor.h"
#include "Goal.h"
#include "VertexQueue.h"

#include <vector>

namespace bonedecimate
{
class ThesisLoop
{
public:
  /// @param tolerance The thesis's w.
  ThesisLoop(Editor& editor, double tolerance, const Stops& stops);

  /// @param monitor Hears fractions from 0 to 1.
  StopReason Run(const Monitor& monitor);
  /// Again, towards something else, after others have changed the mesh.
  StopReason RunTo(const Stops& stops, const Monitor& monitor);

private:
  bool CollapseAt(Index vertex);
  bool CollapseEdge(Index edge);
  void Recost(Index vertex);

  struct CostedEdge
  {
    double Cost; // mm^3
    Index Edge;
  };

  Editor& Work;
  Goal End;
  NormalFieldDeviation Costs;
  VertexQueue Queue;
  std::vector<CostedEdge> EdgesOfVertex;
};
}

#endif
