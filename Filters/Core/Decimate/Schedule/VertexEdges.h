// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexEdges.h
 * @brief The edges at one vertex. They are gathered first and evaluated later, so that their data
 * is prefetched meanwhile.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_VertexEdges_h
#define BoneDecimate_Core_Decimate_Schedule_VertexEdges_h

#include "BucketLists.h"
#include "Decimate/Kernels/EdgeEvaluator.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Data of a sweep beside the mesh, most of it per vertex.
struct SweepData
{
  /// The bucket of the cheapest edge; NeverBucket: removed, constrained, or without an edge to
  /// collapse.
  std::vector<CostBucket> Buckets;
  /// Accumulated error of the collapses into the vertex, units.
  std::vector<float> AccumulatedErrors;
  float CostFactor = 1.0F; ///< CostNormalization() of Decimate/Cost/QuadricDeviation.h.
  /// The factor of Decimate/Cost/SpikePenalty.h.
  double SpikeFactor = 0.0;
  /// What has to be done again because something around the vertex has changed; only if edits are
  /// limited.
  std::vector<std::uint8_t> Changed;
  static constexpr std::uint8_t ToEvaluate = 1; ///< Changed since its bucket was computed.
  static constexpr std::uint8_t ToSearch = 2;   ///< Changed since no collapse was found.

  void NoteAllChanged() { this->Changed.assign(this->Buckets.size(), ToEvaluate | ToSearch); }
  void NoteChange(const std::vector<Index>& vertices)
  {
    for (std::size_t i = 0; i < vertices.size() && !this->Changed.empty(); ++i)
    {
      this->Changed[vertices[i]] = ToEvaluate | ToSearch;
    }
  }
  /// Notes that no edge of the vertex with a cost below its bucket can be collapsed.
  void NoteRejection(VertexId vertex)
  {
    if (!this->Changed.empty())
    {
      this->Changed[vertex] &= ToEvaluate;
    }
  }
  /// Whether nothing has changed since a rejection, so edges below the bucket need not be tried
  /// again.
  bool IsRejected(VertexId vertex) const
  {
    return !this->Changed.empty() && (this->Changed[vertex] & ToSearch) == 0;
  }
  /// Whether the vertex must be evaluated again; resets the flag.
  bool TakeChange(VertexId vertex)
  {
    const bool changed = this->Changed.empty() || this->Changed[vertex] != 0;
    if (!this->Changed.empty())
    {
      this->Changed[vertex] = 0;
    }
    return changed;
  }
};

class VertexEdges
{
public:
  struct Candidate
  {
    Index Edge = None;  ///< None: no edge is left.
    float Move[3] = {}; ///< Relative to the vertex, units.
  };

  void Gather(const HalfEdgeMesh& mesh, const SweepData& data, VertexId vertex, VertexRange block);
  void Evaluate(const EdgeEvaluator& evaluate);

  /// The vertex; None after Forget.
  Index Vertex() const { return this->Center; }
  void Forget() { this->Center = None; }
  /// Whether all edges lie in the block.
  bool AreInside() const { return this->IsInside; }
  /// The smallest cost of the edges not taken yet; infinite if there is none.
  float MinCost() const;
  Candidate TakeCheapest();

private:
  struct Batch
  {
    EdgeBatch Input;
    EdgeResults Results;
    Index Edges[EdgeBatch::Size];
  };
  Batch& BeginBatch(std::size_t batch, const HalfEdgeMesh& mesh, float costFactor);

  Index Center = None;
  bool IsInside = false;
  std::size_t UsedBatches = 0;
  std::vector<Batch> Batches;
};
}

#endif
