// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexBlocks.h
 * @brief The live vertices in their order, cut into blocks that threads process in parallel.
 *
 *     for blocks, blocks shifted by half, larger blocks shifted by half:
 *         in each block, on any thread:  visit the vertices that no earlier pass visited
 *                                        and whose neighbors are all in this block
 *     then, on one thread:               visit the rest
 *
 * Order and blocks depend on the mesh alone, so the result is the same for any number of threads.
 * The vertices of a cleaned surface lie along a space-filling curve, so a block is a patch of the
 * surface.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_VertexBlocks_h
#define BoneDecimate_Core_Decimate_Stages_VertexBlocks_h

#include "Base/Monitor.h"
#include "Base/Parallel.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
class VertexBlocks
{
public:
  explicit VertexBlocks(const HalfEdgeMesh& mesh);

  /// Maximum number of workers.
  int Count() const { return static_cast<int>(this->Order.size() / this->BlockSize) + 2; }

  /**
   * Calls visit(v) once for every live vertex that is not constrained; vertices visited at the same
   * time have no common neighbors. `makeWorker()` makes the visitor of a block. False if the
   * monitor requests a stop.
   */
  template <typename MakeWorker>
  bool ForEach(
    const HalfEdgeMesh& mesh, int threads, const Monitor& monitor, const MakeWorker& makeWorker);

private:
  struct Cut
  {
    Index Size;  // of a block, vertices
    Index Shift; // by how much the first block begins before the first vertex, vertices
    Index BlockOf(Index rank) const { return (rank + this->Shift) / this->Size; }
  };
  template <typename MakeWorker>
  bool VisitBlocks(const HalfEdgeMesh& mesh, const Cut& cut, int threads, const Monitor& monitor,
    const MakeWorker& makeWorker);
  template <typename MakeWorker>
  bool VisitRest(const Monitor& monitor, const MakeWorker& makeWorker);

  /// The vertices at these positions of the order. The first and the last range also include ids
  /// outside of the order.
  VertexRange RangeOf(Index first, Index last) const;
  bool IsInside(const HalfEdgeMesh& mesh, VertexId v, const Cut& cut) const;

  Index BlockSize = 0;      // vertices
  std::vector<Index> Order; // live vertices that may move
  std::vector<Index> Ranks; // of each vertex, in Order
  std::vector<std::uint8_t> Visited;
};

template <typename MakeWorker>
bool VertexBlocks::ForEach(
  const HalfEdgeMesh& mesh, int threads, const Monitor& monitor, const MakeWorker& makeWorker)
{
  std::fill(this->Visited.begin(), this->Visited.end(), 0);
  const Index size = this->BlockSize;
  const Index large = 8 * size;
  return this->VisitBlocks(mesh, { size, 0 }, threads, PartOf(monitor, 0.0, 0.5), makeWorker) &&
    this->VisitBlocks(mesh, { size, size / 2 }, threads, PartOf(monitor, 0.5, 0.8), makeWorker) &&
    this->VisitBlocks(mesh, { large, large / 2 }, threads, PartOf(monitor, 0.8, 0.9), makeWorker) &&
    this->VisitRest(PartOf(monitor, 0.9, 1.0), makeWorker);
}

//------------------------------------------------------------------------------
template <typename MakeWorker>
bool VertexBlocks::VisitBlocks(const HalfEdgeMesh& mesh, const Cut& cut, int threads,
  const Monitor& monitor, const MakeWorker& makeWorker)
{
  const Index count = static_cast<Index>(this->Order.size());
  const auto blocks = static_cast<std::size_t>((count + cut.Shift + cut.Size - 1) / cut.Size);
  return ForEachChunk(blocks, threads, monitor,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      const Index first = std::max(0, static_cast<Index>(begin) * cut.Size - cut.Shift);
      const Index last = std::min(count, static_cast<Index>(end) * cut.Size - cut.Shift);
      auto worker = makeWorker(this->RangeOf(first, last));
      for (Index i = first; i < last; ++i)
      {
        if (!this->Visited[i] && this->IsInside(mesh, this->Order[i], cut))
        {
          this->Visited[i] = 1;
          worker(this->Order[i]);
        }
      }
    });
}

//------------------------------------------------------------------------------
template <typename MakeWorker>
bool VertexBlocks::VisitRest(const Monitor& monitor, const MakeWorker& makeWorker)
{
  constexpr Index visitsPerReport = 64; // vertices
  const Index count = static_cast<Index>(this->Order.size());
  auto worker = makeWorker(this->RangeOf(0, count));
  Index visits = 0;
  for (Index i = 0; i < count; ++i)
  {
    if (this->Visited[i])
    {
      continue;
    }
    worker(this->Order[i]);
    if (++visits % visitsPerReport == 0 && !monitor(static_cast<double>(i) / count))
    {
      return false;
    }
  }
  return true;
}
}

#endif
