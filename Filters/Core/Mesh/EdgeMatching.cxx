// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeMatching.h"

#include "Base/Parallel.h"
#include "HalfEdgeMesh.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Up to this number of half-edges at a point, the search is linear; more are sorted by their
/// target.
constexpr Index LongList = 32;

Index NextCorner(Index k)
{
  return k == 2 ? 0 : k + 1;
}
}

EdgeMatching::EdgeMatching(
  const std::vector<Triangle>& triangles, std::size_t numberOfPoints, int threads)
  : Triangles(triangles)
  , Threads(threads)
{
  this->Match(numberOfPoints);
}

//------------------------------------------------------------------------------
void EdgeMatching::Match(std::size_t numberOfPoints)
{
  this->Start.assign(numberOfPoints + 1, 0);
  this->Spokes.resize(3 * this->Triangles.size());
  this->TwinOf.resize(4 * this->Triangles.size());
  this->SortByOrigin();
  ForEachId(
    this->Triangles.size(), this->Threads, [&](std::size_t t) { this->TwinOf[4 * t + 3] = None; });
  const auto eachBlock = [&](auto step)
  {
    ForEachBlock(numberOfPoints, this->Threads,
      [&](std::size_t, std::size_t first, std::size_t last) { (this->*step)(first, last); });
  };
  eachBlock(&EdgeMatching::SortLongLists);
  eachBlock(&EdgeMatching::MatchBlock);
}

//------------------------------------------------------------------------------
void EdgeMatching::SortByOrigin()
{
  // Counts are stored one index further, so that filling leaves the correct starts.
  for (const Triangle& corners : this->Triangles)
  {
    for (const Index corner : corners)
    {
      ++this->Start[corner];
    }
  }
  Index sum = 0;
  for (Index& start : this->Start)
  {
    sum += start;
    start = sum;
  }
  for (std::size_t t = this->Triangles.size(); t-- > 0;)
  {
    const Triangle& corners = this->Triangles[t];
    for (Index k = 2; k >= 0; --k)
    {
      this->Spokes[--this->Start[corners[k]]] = static_cast<Index>(4 * t) + k;
    }
  }
}

//------------------------------------------------------------------------------
void EdgeMatching::SortLongLists(std::size_t firstPoint, std::size_t lastPoint)
{
  for (std::size_t p = firstPoint; p < lastPoint; ++p)
  {
    if (this->Start[p + 1] - this->Start[p] > LongList)
    {
      std::sort(this->Spokes.begin() + this->Start[p], this->Spokes.begin() + this->Start[p + 1],
        [this](Index a, Index b)
        { return std::make_pair(this->TargetOf(a), a) < std::make_pair(this->TargetOf(b), b); });
    }
  }
}

//------------------------------------------------------------------------------
EdgeMatching::Bundle EdgeMatching::Between(Index from, Index to) const
{
  const Index* first = this->Spokes.data() + this->Start[from];
  const Index* last = this->Spokes.data() + this->Start[from + 1];
  if (last - first > LongList)
  {
    first = std::partition_point(first, last, [&](Index h) { return this->TargetOf(h) < to; });
    last = std::partition_point(first, last, [&](Index h) { return this->TargetOf(h) == to; });
    return { static_cast<Index>(last - first), first != last ? *first : None };
  }
  Bundle bundle;
  for (const Index* spoke = first; spoke != last; ++spoke)
  {
    const bool fits = this->TargetOf(*spoke) == to;
    bundle.Count += fits ? 1 : 0;
    bundle.HalfEdge = fits ? *spoke : bundle.HalfEdge;
  }
  return bundle;
}

//------------------------------------------------------------------------------
/// Stores the half-edges from the neighbors of one point to it.
class EdgeMatching::Marks
{
public:
  /// Stores a half-edge. False if the slot is occupied, by the same neighbor or by another one.
  bool Set(Index point, Index neighbor, HalfEdgeId halfEdge)
  {
    Mark& mark = this->At(neighbor);
    const bool isFree = mark.Point != point;
    mark = { point, neighbor, halfEdge };
    return isFree;
  }

  /// Removes the half-edge from the neighbor to the point; None if there is none or it was removed
  /// before.
  Index Take(Index point, Index neighbor)
  {
    Mark& mark = this->At(neighbor);
    const bool isThere = mark.Point == point && mark.Neighbor == neighbor;
    const Index halfEdge = isThere ? mark.HalfEdge : None;
    mark.HalfEdge = None;
    return halfEdge;
  }

private:
  struct Mark
  {
    Index Point = None;
    Index Neighbor = None;
    Index HalfEdge = None;
  };
  static constexpr std::size_t Size = 1024; // fits into the first-level cache
  Mark& At(Index neighbor) { return this->Table[static_cast<std::size_t>(neighbor) % Size]; }
  std::array<Mark, Size> Table;
};

//------------------------------------------------------------------------------
/// Each half-edge is written by the block of its origin only.
void EdgeMatching::MatchBlock(std::size_t firstPoint, std::size_t lastPoint)
{
  Marks marks;
  for (std::size_t p = firstPoint; p < lastPoint; ++p)
  {
    if (!this->MatchPairs(static_cast<Index>(p), marks))
    {
      this->MatchOneByOne(static_cast<Index>(p));
    }
  }
}

//------------------------------------------------------------------------------
/// Each triangle at the point has one outgoing and one incoming half-edge. False if these do not
/// pair one to one.
bool EdgeMatching::MatchPairs(Index point, Marks& marks)
{
  bool paired = true;
  const Index* first = this->Spokes.data() + this->Start[point];
  const Index* last = this->Spokes.data() + this->Start[point + 1];
  for (const Index* spoke = first; spoke != last; ++spoke)
  {
    const HalfEdgeId arriving = HalfEdgeMesh::Previous(*spoke);
    const Index origin = this->Triangles[arriving >> 2][arriving & 3];
    paired = marks.Set(point, origin, arriving) && paired;
  }
  for (const Index* spoke = first; spoke != last; ++spoke)
  {
    const Index target = this->TargetOf(*spoke);
    const Index twin = marks.Take(point, target);
    this->TwinOf[*spoke] = twin;
    paired = paired && twin != None && target != point;
  }
  return paired;
}

//------------------------------------------------------------------------------
void EdgeMatching::MatchOneByOne(Index point)
{
  for (Index i = this->Start[point]; i < this->Start[point + 1]; ++i)
  {
    const Index target = this->TargetOf(this->Spokes[i]);
    const Bundle back = this->Between(target, point);
    const bool alone = this->Between(point, target).Count == 1 && target != point;
    const bool isPair = alone && back.Count == 1;
    this->TwinOf[this->Spokes[i]] = isPair    ? back.HalfEdge
      : this->CountOnEdge(point, target) == 1 ? None
                                              : OddEdge;
  }
}

//------------------------------------------------------------------------------
Index EdgeMatching::TargetOf(Index halfEdge) const
{
  return this->Triangles[halfEdge >> 2][NextCorner(halfEdge & 3)];
}

//------------------------------------------------------------------------------
std::vector<Index> EdgeMatching::OutgoingAt(Index point) const
{
  std::vector<Index> outgoing(
    this->Spokes.begin() + this->Start[point], this->Spokes.begin() + this->Start[point + 1]);
  std::sort(outgoing.begin(), outgoing.end());
  return outgoing;
}

//------------------------------------------------------------------------------
Index EdgeMatching::CountOnEdge(Index a, Index b) const
{
  return this->Between(a, b).Count + (a == b ? 0 : this->Between(b, a).Count);
}

//------------------------------------------------------------------------------
/// Whether this is the first half-edge of its edge, so that each edge is counted once.
bool EdgeMatching::IsFirstOnEdge(Index origin, Index halfEdge) const
{
  const Index target = this->TargetOf(halfEdge);
  return (origin <= target || this->Between(target, origin).Count == 0) &&
    this->Between(origin, target).HalfEdge == halfEdge;
}

//------------------------------------------------------------------------------
EdgeCounts EdgeMatching::CountEdges() const
{
  EdgeCounts counts = SumOverBlocks(this->Triangles.size(), this->Threads,
    [this](std::size_t first, std::size_t last)
    {
      EdgeCounts part;
      for (std::size_t f = first; f < last; ++f)
      {
        this->CountEdgesOf(static_cast<Index>(f), part);
      }
      return part;
    });
  counts.Edges += counts.Boundary + counts.PairedHalfEdges / 2;
  return counts;
}

//------------------------------------------------------------------------------
void EdgeMatching::CountEdgesOf(Index triangle, EdgeCounts& counts) const
{
  for (Index k = 0; k < 3; ++k)
  {
    const Index h = 4 * triangle + k;
    const Index twin = this->TwinOf[static_cast<std::size_t>(h)];
    counts.PairedHalfEdges += twin >= 0 ? 1 : 0;
    counts.Boundary += twin == None ? 1 : 0;
    const Index origin =
      this->Triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)];
    if (twin == OddEdge && this->IsFirstOnEdge(origin, h))
    {
      ++counts.Edges;
      counts.NonManifold += this->CountOnEdge(origin, this->TargetOf(h)) > 2 ? 1 : 0;
    }
  }
}

//------------------------------------------------------------------------------
void EdgeMatching::CutBetween(const std::vector<Index>& labels)
{
  for (Index h = 0; h < static_cast<Index>(this->TwinOf.size()) && !labels.empty(); ++h)
  {
    const Index twin = this->TwinOf[h];
    if (twin > h && labels[h >> 2] != labels[twin >> 2])
    {
      this->TwinOf[h] = this->TwinOf[twin] = OddEdge;
    }
  }
}

//------------------------------------------------------------------------------
Rings EdgeMatching::FindRings() const
{
  const std::size_t numberOfPoints = this->Start.size() - 1;
  Rings rings;
  rings.Outgoing.resize(numberOfPoints);
  rings.Constraints.resize(numberOfPoints);
  ForEachBlock(numberOfPoints, this->Threads,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        this->FindRing(static_cast<Index>(p), rings);
      }
    });
  return rings;
}

//------------------------------------------------------------------------------
std::vector<Index> NonManifoldPoints(const Rings& rings)
{
  std::vector<Index> points;
  for (std::size_t p = 0; p < rings.Constraints.size(); ++p)
  {
    if (rings.Constraints[p] == VertexConstraint::NonManifold)
    {
      points.push_back(static_cast<Index>(p));
    }
  }
  return points;
}

//------------------------------------------------------------------------------
void EdgeMatching::FindRing(Index point, Rings& rings) const
{
  Index least = None;
  Index alone = None;
  Index worst = 0; // None is a boundary, OddEdge is worse
  for (Index i = this->Start[point]; i < this->Start[point + 1]; ++i)
  {
    const Index h = this->Spokes[i];
    least = least == None ? h : std::min(least, h);
    alone = this->TwinOf[h] < 0 ? std::max(alone, h) : alone;
    worst = std::min({ worst, this->TwinOf[h], this->TwinOf[HalfEdgeMesh::Previous(h)] });
  }
  const Index start = alone == None ? least : alone;
  // terminates: twins are paired one to one, so a ring ends or returns to its start
  Index found = 0;
  for (Index h = start; h >= 0;)
  {
    ++found;
    h = this->TwinOf[HalfEdgeMesh::Previous(h)];
    h = h == start ? None : h;
  }
  const bool isOneFan = found == this->Start[point + 1] - this->Start[point];
  rings.Outgoing[point] = start;
  rings.Constraints[point] = worst == OddEdge || !isOneFan ? VertexConstraint::NonManifold
    : worst == None                                        ? VertexConstraint::Boundary
                                                           : VertexConstraint::Free;
}
}
