// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NewCrossings.h"

#include "Base/Parallel.h"
#include "Motion.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace bonedecimate
{
namespace
{
constexpr std::size_t LeafSize = 8;       // triangles
constexpr std::size_t LeavesOfBlock = 64; // of work

PlaneTriangle PlaneTriangleOf(const std::vector<Vector3>& points, const Triangle& c)
{
  return PlaneTriangle({ points[c[0]], points[c[1]], points[c[2]] });
}

}

/// The triangles of a leaf at their moved positions.
struct NewCrossings::Leaf
{
  std::size_t FirstTriangle = 0;
  std::size_t EndTriangle = 0;
  std::array<PlaneTriangle, LeafSize> Triangles;
};

NewCrossings::NewCrossings(const Surface& before, Times times, int threads)
  : SurfaceBefore(before)
  , CheckedTimes(times)
  , Threads(threads)
  , Leaves(1)
{
  while (this->Leaves * LeafSize < before.Triangles.size())
  {
    this->Leaves *= 2;
  }
}

//------------------------------------------------------------------------------
void NewCrossings::FillTree(const std::vector<Vector3>& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Box empty = { Vector3::Constant(infinity), Vector3::Constant(-infinity) };
  this->Boxes.assign(2 * this->Leaves, empty);
  this->TriangleBoxes.resize(this->SurfaceBefore.Triangles.size());
  const auto boxOf = [](const std::vector<Vector3>& at, const Triangle& c)
  {
    return Box{ at[c[0]].cwiseMin(at[c[1]]).cwiseMin(at[c[2]]),
      at[c[0]].cwiseMax(at[c[1]]).cwiseMax(at[c[2]]) };
  };
  const auto join = [](Box& box, const Box& other)
  {
    box.Low = box.Low.cwiseMin(other.Low);
    box.High = box.High.cwiseMax(other.High);
  };
  const std::size_t count = this->SurfaceBefore.Triangles.size();
  ForEachId((count + LeafSize - 1) / LeafSize, this->Threads,
    [&](std::size_t leaf)
    {
      Box& box = this->Boxes[this->Leaves + leaf];
      for (std::size_t t = LeafSize * leaf; t < std::min(count, LeafSize * (leaf + 1)); ++t)
      {
        const Triangle& c = this->SurfaceBefore.Triangles[t];
        this->TriangleBoxes[t] = boxOf(points, c);
        if (this->CheckedTimes == Times::All)
        {
          join(this->TriangleBoxes[t], boxOf(this->SurfaceBefore.Points, c));
        }
        join(box, this->TriangleBoxes[t]);
      }
    });
  for (std::size_t node = this->Leaves; node-- > 1;)
  {
    join(this->Boxes[node], this->Boxes[2 * node]);
    join(this->Boxes[node], this->Boxes[2 * node + 1]);
  }
}

//------------------------------------------------------------------------------
/// The leaf itself, and the later or all leaves whose boxes overlap its box.
void NewCrossings::FindNear(
  std::size_t leaf, bool withEarlier, std::vector<std::size_t>& leaves) const
{
  const Box& box = this->Boxes[this->Leaves + leaf];
  leaves.assign(1, leaf);
  for (std::size_t node = this->Leaves + leaf; node > 1; node /= 2)
  {
    if (node % 2 == 0)
    {
      this->FindBelow(node + 1, box, leaves);
    }
    else if (withEarlier)
    {
      this->FindBelow(node - 1, box, leaves);
    }
  }
}

//------------------------------------------------------------------------------
void NewCrossings::FindBelow(
  std::size_t root, const Box& box, std::vector<std::size_t>& leaves) const
{
  std::array<std::size_t, 128> stack; // never more than twice the depth of the tree
  std::size_t size = 0;
  stack[size++] = root;
  while (size > 0)
  {
    const std::size_t node = stack[--size];
    if (!this->Boxes[node].Overlaps(box))
    {
      continue;
    }
    if (node >= this->Leaves)
    {
      leaves.push_back(node - this->Leaves);
    }
    else
    {
      stack[size++] = 2 * node + 1;
      stack[size++] = 2 * node;
    }
  }
}

//------------------------------------------------------------------------------
bool NewCrossings::IsTurnedOver(const std::vector<Vector3>& points, const Triangle& c) const
{
  const auto areaOf = [&c](const std::vector<Vector3>& at)
  { return Vector3((at[c[1]] - at[c[0]]).cross(at[c[2]] - at[c[0]])); };
  const Vector3 before = areaOf(this->SurfaceBefore.Points);
  return before.squaredNorm() > 0.0 && !(Dot(before, areaOf(points)) > 0.0);
}

/// Whether two triangles intersect now or have passed through each other, and did not before. A
/// pair that touched before may touch, but not pierce each other.
bool NewCrossings::IsNew(const Pair& now, std::size_t a, std::size_t b) const
{
  const Triangle& first = this->SurfaceBefore.Triangles[a];
  const Triangle& second = this->SurfaceBefore.Triangles[b];
  const int common = CountCommon(first, second);
  const bool isWatched = this->CheckedTimes == Times::All && common == 0;
  const bool intersect = common < 3 && Meet(now.First, first, now.Second, second);
  if (!intersect && !isWatched)
  {
    return false;
  }
  const PlaneTriangle firstBefore = PlaneTriangleOf(this->SurfaceBefore.Points, first);
  const PlaneTriangle secondBefore = PlaneTriangleOf(this->SurfaceBefore.Points, second);
  if (Meet(firstBefore, first, secondBefore, second))
  {
    return intersect && Pierce(now.First, now.Second) && !Pierce(firstBefore, secondBefore);
  }
  return intersect ||
    !StayApart(
      { firstBefore.Corners, secondBefore.Corners }, { now.First.Corners, now.Second.Corners });
}

//------------------------------------------------------------------------------
/// Finds the pairs with a moved triangle of the leaf. A pair of two moved ones belongs to the leaf
/// of the first.
void NewCrossings::FindOfLeaf(std::size_t leaf, const Query& query, std::vector<Index>& found) const
{
  const std::size_t first = LeafSize * leaf;
  const std::size_t last = std::min(this->SurfaceBefore.Triangles.size(), first + LeafSize);
  if (std::none_of(query.IsMoved.begin() + static_cast<std::ptrdiff_t>(first),
        query.IsMoved.begin() + static_cast<std::ptrdiff_t>(last),
        [](char moved) { return moved != 0; }))
  {
    return;
  }
  std::vector<std::size_t> leaves;
  this->FindNear(leaf, !query.AreAllMoved, leaves);
  Leaf own = { first, last, {} };
  for (std::size_t t = first; t < last; ++t)
  {
    own.Triangles[t - first] = PlaneTriangleOf(query.Points, this->SurfaceBefore.Triangles[t]);
    if (query.IsMoved[t] != 0 && this->IsTurnedOver(query.Points, this->SurfaceBefore.Triangles[t]))
    {
      found.push_back(static_cast<Index>(t));
    }
  }
  for (const std::size_t near : leaves)
  {
    const std::size_t end = std::min(this->SurfaceBefore.Triangles.size(), LeafSize * (near + 1));
    for (std::size_t u = LeafSize * near; u < end; ++u)
    {
      if (this->Boxes[this->Leaves + leaf].Overlaps(this->TriangleBoxes[u]))
      {
        this->FindOfTriangle(u, own, query, found);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Finds the pairs of a triangle and moved triangles of the leaf.
void NewCrossings::FindOfTriangle(
  std::size_t u, const Leaf& leaf, const Query& query, std::vector<Index>& found) const
{
  std::optional<PlaneTriangle> other;
  for (std::size_t t = leaf.FirstTriangle; t < leaf.EndTriangle; ++t)
  {
    const bool isOfThisLeaf = query.IsMoved[t] != 0 && (query.IsMoved[u] == 0 || t < u);
    if (isOfThisLeaf && this->TriangleBoxes[t].Overlaps(this->TriangleBoxes[u]))
    {
      if (!other)
      {
        other = PlaneTriangleOf(query.Points, this->SurfaceBefore.Triangles[u]);
      }
      if (this->IsNew({ leaf.Triangles[t - leaf.FirstTriangle], *other }, t, u))
      {
        found.push_back(static_cast<Index>(t));
        found.push_back(static_cast<Index>(u));
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<Index> NewCrossings::Find(
  const std::vector<Vector3>& points, const std::vector<char>& isMoved, const Monitor& monitor)
{
  this->FillTree(points);
  const Query query = { points, isMoved,
    std::all_of(isMoved.begin(), isMoved.end(), [](char moved) { return moved != 0; }) };
  const std::size_t leaves = (this->SurfaceBefore.Triangles.size() + LeafSize - 1) / LeafSize;
  std::vector<std::vector<Index>> parts((leaves + LeavesOfBlock - 1) / LeavesOfBlock);
  ForEachPart(parts.size(), this->Threads, monitor,
    [&](std::size_t part)
    {
      const std::size_t end = std::min(leaves, (part + 1) * LeavesOfBlock);
      for (std::size_t leaf = part * LeavesOfBlock; leaf < end; ++leaf)
      {
        this->FindOfLeaf(leaf, query, parts[part]);
      }
    });
  std::vector<Index> found;
  for (const std::vector<Index>& part : parts)
  {
    found.insert(found.end(), part.begin(), part.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}
}
