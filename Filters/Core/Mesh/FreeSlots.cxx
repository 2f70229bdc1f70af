// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FreeSlots.h"

namespace bonedecimate
{
FreeSlots::FreeSlots(const std::vector<char>& isFree)
  : Upward(isFree.size() + 2)
  , Downward(isFree.size() + 2)
{
  const auto last = static_cast<Index>(isFree.size()) + 1;
  for (Index at = 0; at <= last; ++at)
  {
    const bool isEnd = at == 0 || at == last;
    const bool stays = isEnd || isFree[static_cast<std::size_t>(at) - 1] != 0;
    this->Upward[static_cast<std::size_t>(at)] = stays ? at : at + 1;
    this->Downward[static_cast<std::size_t>(at)] = stays ? at : at - 1;
    this->Remaining += stays && !isEnd ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
/// Follows links to the end, with path halving.
Index FreeSlots::Follow(std::vector<Index>& next, Index at)
{
  while (next[static_cast<std::size_t>(at)] != at)
  {
    Index& there = next[static_cast<std::size_t>(at)];
    there = next[static_cast<std::size_t>(there)];
    at = there;
  }
  return at;
}

//------------------------------------------------------------------------------
Index FreeSlots::FindNearest(Index id, Index except)
{
  const auto last = static_cast<Index>(this->Upward.size()) - 1;
  const Index at = id + 1;
  Index above = Follow(this->Upward, at);
  Index below = Follow(this->Downward, at);
  above = above == except + 1 && above != 0 ? Follow(this->Upward, above + 1) : above;
  below = below == except + 1 && below != 0 ? Follow(this->Downward, below - 1) : below;
  if (below == 0 && above == last)
  {
    return None;
  }
  const bool takesBelow = below != 0 && (above == last || at - below <= above - at);
  return (takesBelow ? below : above) - 1;
}

//------------------------------------------------------------------------------
void FreeSlots::Take(Index id)
{
  const auto at = static_cast<std::size_t>(id) + 1;
  this->Upward[at] = id + 2;
  this->Downward[at] = id;
  --this->Remaining;
}

//------------------------------------------------------------------------------
FreeSlots FreeVertices(const HalfEdgeMesh& mesh)
{
  std::vector<char> isFree(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0);
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    const bool isAlone = mesh.OriginalVertex(v) == v && mesh.NextDuplicate(v) == v;
    isFree[static_cast<std::size_t>(v)] =
      mesh.Outgoing(v) == None && isAlone && mesh.Constraint(v) != VertexConstraint::NonManifold
      ? 1
      : 0;
  }
  return FreeSlots(isFree);
}

//------------------------------------------------------------------------------
FreeSlots FreeFaces(const HalfEdgeMesh& mesh)
{
  std::vector<char> isFree(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), 0);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    isFree[static_cast<std::size_t>(face)] = mesh.IsAlive(face) ? 0 : 1;
  }
  return FreeSlots(isFree);
}
}
