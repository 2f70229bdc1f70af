// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexLists.h
 * @brief The vertices of a sweep in lists by the bucket of their cheapest edge, updated as edges
 * are collapsed.
 *
 * Neighbors of a merged vertex keep their buckets although their costs change: they are evaluated
 * again when they are processed. If few faces remain, this costs accuracy, so RenewsRing computes
 * their buckets at once.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_VertexLists_h
#define BoneDecimate_Core_Decimate_Schedule_VertexLists_h

#include "CollapseSearch.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
class VertexLists
{
public:
  VertexLists(const HalfEdgeMesh& mesh, const EdgeEvaluator& evaluate, SweepData& data)
    : Mesh(mesh)
    , Evaluate(evaluate)
    , Data(data)
  {
  }

  /// Lists the vertices of the task whose buckets are not above its limit.
  void Fill(const BlockTask& task);

  /// Moves the lowest list to `vertices`. Returns its highest bucket that is not above the limit.
  CostBucket TakeLowest(std::vector<Index>& vertices)
  {
    return std::min(this->Lists.TakeLowest(vertices), this->Task.Limit);
  }

  /// Notes that no collapse was found at the vertex.
  /// @param bucket The bucket of the edges left to try.
  /// @param isLasting Whether edges below the bucket stay rejected until something changes.
  void Reject(VertexId vertex, CostBucket bucket, bool isLasting);
  /// Computes the bucket of a vertex: that of its cheapest edge.
  /// @param within Vertices that may be read.
  void Renew(VertexId vertex, VertexRange within);
  /// Updates the lists after a collapse.
  /// @param around The neighborhood of the collapsed edge.
  void Update(
    const Edit& edit, VertexId gone, double accumulatedError, const EdgeNeighborhood& around);

private:
  void SetBucket(VertexId vertex, CostBucket bucket);

  const HalfEdgeMesh& Mesh;
  const EdgeEvaluator& Evaluate;
  SweepData& Data;
  BlockTask Task;
  BucketLists Lists;
  VertexEdges Edges; // of the last vertex passed to Renew
};
}

#endif
