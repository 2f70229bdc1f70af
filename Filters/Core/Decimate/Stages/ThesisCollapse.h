// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThesisCollapse.h
 * @brief The loop of the thesis: lowest vertex, then its lowest edge, until the number or the error
 * is reached.
 *
 *     put every vertex in a queue by its cost
 *     while faces > Faces or maxError < Error:
 *         v = vertex of lowest cost; for its edges e = (v, ve), lowest cost first:
 *             collapse e with the first position that is accepted, and continue with the queue
 *         if all its edges are rejected, v waits until something around it changes
 *         recompute the costs of the new vertex and its one-ring
 *
 * Only the ring of the new vertex has changed: it contains the one-rings of both v and ve.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ThesisCollapse_h
#define BoneDecimate_Core_Decimate_Stages_ThesisCollapse_h

#include "Decimate/Cost/VertexCost.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Schedule/StopCriterion.h"
#include "Decimate/Schedule/VertexQueue.h"
#include "Options/Modes.h"

#include <memory>
#include <vector>

namespace bonedecimate
{
class ThesisCollapse
{
public:
  /// @param tolerance w of the thesis.
  ThesisCollapse(Editor& editor, const QueuePolicies& policies, double tolerance);

  /// May run again with other targets after other stages have changed the mesh.
  /// @param monitor Receives fractions from 0 to 1.
  StopReason Run(const StopTargets& stops, const Monitor& monitor);

private:
  bool CollapseAt(VertexId vertex);
  bool CollapseEdge(HalfEdgeId edge);
  void Recost(VertexId vertex);

  struct CostedEdge
  {
    double Cost; // mm^3
    Index Edge;
  };

  Editor& MeshEditor;
  EditWorkspace Workspace;
  StopCriterion End;
  QueuePolicies Policies;
  std::unique_ptr<VertexCost> Costs;
  VertexQueue Queue;
  std::vector<CostedEdge> EdgesOfVertex;
};
}

#endif
