// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexEdges.h
 * @brief The edges at one vertex, gathered first and evaluated later, so that their data is
 * prefetched meanwhile.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_VertexEdges_h
#define BoneDecimate_Core_Decimate_Schedule_VertexEdges_h

#include "BucketLists.h"
#include "Decimate/Kernels/EdgeEvaluator.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <vector>

namespace bonedecimate
{
/// Data of a sweep for every vertex, beside the mesh.
struct SweepData
{
  /// NeverBucket: removed, constrained, or without an edge to collapse.
  std::vector<CostBucket> Buckets;
  /// Accumulated error of the collapses into the vertex, units of the mesh.
  std::vector<float> AccumulatedErrors;
  float CostFactor = 1.0F; ///< CostNormalization() of Decimate/Cost/QuadricDeviation.h.
  /// The factor of Decimate/Cost/SpikePenalty.h.
  double SpikeFactor = 0.0;
  /// Only if edits are limited, of each vertex: what has to be done again because something around
  /// it has changed.
  std::vector<std::uint8_t> Changed;
  static constexpr std::uint8_t ToEvaluate = 1; ///< Since its bucket was computed for this pass.
  static constexpr std::uint8_t ToSearch = 2;   ///< Since no collapse was found there.

  void NoteAllChanged() { this->Changed.assign(this->Buckets.size(), ToEvaluate | ToSearch); }
  void NoteChange(const std::vector<Index>& vertices)
  {
    for (std::size_t i = 0; i < vertices.size() && !this->Changed.empty(); ++i)
    {
      this->Changed[vertices[i]] = ToEvaluate | ToSearch;
    }
  }
  /// No edge of the vertex with a cost below its bucket may be collapsed.
  void NoteRejection(VertexId vertex)
  {
    if (!this->Changed.empty())
    {
      this->Changed[vertex] &= ToEvaluate;
    }
  }
  /// Whether nothing has changed since: then edges below its bucket need not be tried again.
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
    Index Edge = None;  ///< None: there is none.
    float Move[3] = {}; ///< From the vertex, units.
  };

  void Gather(const HalfEdgeMesh& mesh, const SweepData& data, VertexId vertex, VertexRange block);
  void Evaluate(const EdgeEvaluator& evaluate);

  /// None after Forget.
  Index Vertex() const { return this->Center; }
  void Forget() { this->Center = None; }
  /// Whether no edge leads out of the block.
  bool AreInside() const { return this->IsInside; }
  /// The least cost of the edges not taken yet; infinite if there is none.
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
