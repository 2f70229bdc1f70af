// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexLists.h
 * @brief The vertices of a sweep in lists by the bucket of their cheapest edge, kept up to date
 * while edges are collapsed.
 *
 * Neighbors of a merged vertex keep their buckets although their costs changed, because they are
 * evaluated again when they are processed. When few faces remain, that loses accuracy, so
 * RenewsRing computes their buckets at once.
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

  /// Lists the vertices of the task that are not above its limit.
  void Fill(const BlockTask& task);

  /// Moves the lowest list there is to `vertices`; returns its highest bucket that is not above the
  /// limit.
  CostBucket TakeLowest(std::vector<Index>& vertices)
  {
    return std::min(this->Lists.TakeLowest(vertices), this->Task.Limit);
  }

  /// No collapse was found at the vertex.
  /// @param bucket The bucket of the edges that are left to try.
  /// @param isLasting Whether edges below the bucket are rejected until something changes.
  void Reject(VertexId vertex, CostBucket bucket, bool isLasting);
  /// Computes the bucket of a vertex, that of its cheapest edge.
  /// @param within Vertices that may be read.
  void Renew(VertexId vertex, VertexRange within);
  /// After the collapse.  @param around What was around the edge that was collapsed.
  void Update(
    const Edit& edit, VertexId gone, double accumulatedError, const EdgeNeighborhood& around);

private:
  void SetBucket(VertexId vertex, CostBucket bucket);

  const HalfEdgeMesh& Mesh;
  const EdgeEvaluator& Evaluate;
  SweepData& Data;
  BlockTask Task;
  BucketLists Lists;
  VertexEdges Edges; // of the vertex renewed last
};
}

#endif
