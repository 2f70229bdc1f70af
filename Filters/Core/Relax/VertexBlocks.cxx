// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexBlocks.h"

#include <numeric>

namespace bonedecimate
{
namespace
{
/// Two zero bits between any two of the lowest 21 bits.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1f00000000ffffULL;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

std::uint64_t CurveCode(const Vector3& p, const Vector3& low, double cellsOverLength)
{
  const Vector3 cell = cellsOverLength * (p - low);
  return Spread(static_cast<std::uint64_t>(cell.x())) |
    Spread(static_cast<std::uint64_t>(cell.y())) << 1 |
    Spread(static_cast<std::uint64_t>(cell.z())) << 2;
}
}

VertexBlocks::VertexBlocks(const HalfEdgeMesh& mesh)
  : Ranks(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
{
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Outgoing(v) != None && mesh.Kind(v) != VertexKind::Locked)
    {
      this->Order.push_back(v);
    }
  }
  this->Visited.resize(this->Order.size(), 0);
  if (this->Order.empty())
  {
    return;
  }
  Vector3 low = mesh.Position(this->Order.front());
  Vector3 high = low;
  for (const Index v : this->Order)
  {
    low = low.cwiseMin(mesh.Position(v));
    high = high.cwiseMax(mesh.Position(v));
  }
  const double length = (high - low).maxCoeff();
  const double cells = length > 0.0 ? 2097151.0 / length : 0.0; // 2^21 - 1
  std::vector<std::uint64_t> codes(this->Ranks.size(), 0);
  for (const Index v : this->Order)
  {
    codes[v] = CurveCode(mesh.Position(v), low, cells);
  }
  std::sort(this->Order.begin(), this->Order.end(),
    [&](Index a, Index b) { return codes[a] != codes[b] ? codes[a] < codes[b] : a < b; });
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->Ranks[this->Order[i]] = static_cast<Index>(i);
  }
}

//------------------------------------------------------------------------------
bool VertexBlocks::IsInside(const HalfEdgeMesh& mesh, Index v, Index shift) const
{
  const Index block = this->BlockOf(v, shift);
  bool inside = true;
  mesh.VisitEdges(v,
    [&](Index h)
    {
      const Index other = mesh.Across(h, v);
      inside = inside && this->Ranks[other] != None && this->BlockOf(other, shift) == block;
    });
  return inside;
}
}
