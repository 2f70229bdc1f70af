// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexEdges.h
 * @brief The edges at one vertex, gathered first and judged later, so that the processor can fetch what judging needs.
 */
#ifndef BoneDecimate_Core_Collapse_VertexEdges_h
#define BoneDecimate_Core_Collapse_VertexEdges_h

#include "Kernels/Kernels.h"
#include "LevelLists.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <vector>

namespace bonedecimate
{
/// What a sweep knows of every vertex, beside the mesh.
struct VertexKeys
{
  std::vector<CostKey> Keys; ///< NeverKey: gone, locked, or nothing to collapse.
  /// Distance left behind so far by what was merged into it, units of the mesh.
  std::vector<float> Memories;
  float CostFactor = 1.0F; ///< Makes costs independent of how the unit was rounded.
  /// A distance left behind, units, to the power of 3/2 times this over the number of faces is the least cost that such
  /// a collapse has.
  double PeakFactor = 0.0;
  /// Kept where edits are proved: whether anything around a vertex has changed since it was given its key.
  std::vector<std::uint8_t> Changed;

  void NoteChange(const std::vector<Index>& vertices)
  {
    for (std::size_t i = 0; i < vertices.size() && !this->Changed.empty(); ++i)
    {
      this->Changed[vertices[i]] = 1;
    }
  }
  /// Whether it has to be asked again.
  bool TakeChange(Index vertex)
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

  void Gather(const HalfEdgeMesh& mesh, const VertexKeys& known, Index vertex, VertexRange block);
  void Judge(const Kernels& kernels);

  /// None after Forget.
  Index Vertex() const { return this->Middle; }
  void Forget() { this->Middle = None; }
  /// Whether no edge leads out of the block.
  bool AreInside() const { return this->Inside; }
  /// Of the edges not taken yet; infinite if there is none.
  float LeastCost() const;
  Candidate TakeCheapest();

private:
  struct Batch
  {
    EdgeBatch Asked;
    EdgeAnswers Answers;
    Index Edges[EdgeBatch::Size];
  };
  Batch& Begin(std::size_t batch, const HalfEdgeMesh& mesh, float costFactor);

  Index Middle = None;
  bool Inside = false;
  std::size_t Used = 0;
  std::vector<Batch> Batches;
};
}

#endif
