// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexBlocks.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Large blocks leave few vertices whose ring is in no block, and many blocks keep many threads
/// busy.
constexpr Index BlocksOfOrder = 32;
constexpr Index MinBlock = 512;
constexpr Index MaxBlock = 8192;
}

VertexBlocks::VertexBlocks(const HalfEdgeMesh& mesh)
  : Ranks(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
{
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Outgoing(v) != None && !mesh.IsConstrained(v))
    {
      this->Ranks[v] = static_cast<Index>(this->Order.size());
      this->Order.push_back(v);
    }
  }
  this->Visited.resize(this->Order.size(), 0);
  this->BlockSize =
    std::clamp(static_cast<Index>(this->Order.size()) / BlocksOfOrder, MinBlock, MaxBlock);
}

//------------------------------------------------------------------------------
VertexRange VertexBlocks::RangeOf(Index first, Index last) const
{
  const Index count = static_cast<Index>(this->Order.size());
  VertexRange range;
  range.First = first == 0 ? 0 : this->Order[first];
  range.End = last == count ? static_cast<Index>(this->Ranks.size()) : this->Order[last];
  return range;
}

//------------------------------------------------------------------------------
bool VertexBlocks::IsInside(const HalfEdgeMesh& mesh, VertexId v, const Cut& cut) const
{
  const Index block = cut.BlockOf(this->Ranks[v]);
  bool inside = true;
  mesh.VisitEdges(v,
    [&](HalfEdgeId h)
    {
      const VertexId other = mesh.OtherEnd(h, v);
      inside = inside && (this->Ranks[other] == None || cut.BlockOf(this->Ranks[other]) == block);
    });
  return inside;
}
}
