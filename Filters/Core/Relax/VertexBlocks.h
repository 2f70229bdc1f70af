// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexBlocks.h
 * @brief The live vertices in their order, cut into blocks that threads may work on.
 *
 *     for shift in 0, 1/2:   each block, on any thread:  visit the vertices that no earlier pass visited
 *                                                         and whose neighbours are all in this block
 *     then, on one thread:   visit the rest
 *
 * Order and blocks depend on the mesh alone, so that the result is the same for any number of threads. The
 * vertices of a cleaned surface lie along a curve that fills space: a block is a patch.
 */
#ifndef BoneDecimate_Core_Relax_VertexBlocks_h
#define BoneDecimate_Core_Relax_VertexBlocks_h

#include "Mesh/HalfEdgeMesh.h"
#include "Monitor.h"
#include "Parallel.h"

#include <vector>

namespace bonedecimate
{
class VertexBlocks
{
public:
  explicit VertexBlocks(const HalfEdgeMesh& mesh);

  /// How many workers there may be at most.
  int Count() const { return static_cast<int>(this->Order.size() / BlockSize) + 2; }

  /**
   * Calls visit(v) once for every live vertex that is not locked; those visited at the same time have no common
   * neighbours. `worker()` makes the visitor of a block.
   */
  template <typename MakeWorker>
  bool ForEach(
    const HalfEdgeMesh& mesh, int threads, const Monitor& monitor, const MakeWorker& makeWorker);

private:
  static constexpr Index BlockSize = 1024;

  Index BlockOf(Index v, Index shift) const { return (this->Ranks[v] + shift) / BlockSize; }
  bool IsInside(const HalfEdgeMesh& mesh, Index v, Index shift) const;

  std::vector<Index> Order; // live vertices that are not locked
  std::vector<Index> Ranks; // of each vertex in Order
  std::vector<std::uint8_t> Visited;
};

template <typename MakeWorker>
bool VertexBlocks::ForEach(
  const HalfEdgeMesh& mesh, int threads, const Monitor& monitor, const MakeWorker& makeWorker)
{
  const Index count = static_cast<Index>(this->Order.size());
  std::fill(this->Visited.begin(), this->Visited.end(), 0);
  const auto visitAll = [&](Index first, Index last, auto mayVisit)
  {
    auto worker = makeWorker();
    for (Index i = std::max(0, first); i < std::min(count, last); ++i)
    {
      if (!this->Visited[i] && mayVisit(this->Order[i]))
      {
        this->Visited[i] = 1;
        worker(this->Order[i]);
      }
    }
  };
  for (const Index shift : { 0, BlockSize / 2 })
  {
    const auto blocks = static_cast<std::size_t>((count + shift + BlockSize - 1) / BlockSize);
    const bool goesOn = ForEachChunk(blocks, threads, monitor,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        const Index first = static_cast<Index>(begin) * BlockSize - shift;
        const Index last = static_cast<Index>(end) * BlockSize - shift;
        visitAll(first, last, [&](Index v) { return this->IsInside(mesh, v, shift); });
      });
    if (!goesOn)
    {
      return false;
    }
  }
  visitAll(0, count, [](Index) { return true; });
  return true;
}
}

#endif
