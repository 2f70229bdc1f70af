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

/// Corners that two triangles have in common, by their numbers in each.
struct CommonCorners
{
  CommonCorners(const Triangle& a, const Triangle& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        if (a[i] == b[j])
        {
          ++this->Count;
          this->SumA += i;
          this->SumB += j;
        }
      }
    }
  }
  std::size_t Count = 0;
  std::size_t SumA = 0, SumB = 0; // of one: its number; of two: 3 less that of the third corner
};

bool Intersect(const PlaneTriangle& first, const PlaneTriangle& second, const CommonCorners& common)
{
  switch (common.Count)
  {
    case 0:
      return Meet(first, second);
    case 1:
      return MeetBeyondCorner(first, common.SumA, second, common.SumB);
    case 2:
      return MeetBeyondEdge(first, 3 - common.SumA, second.Corners[3 - common.SumB]);
    default:
      return false;
  }
}
}

/// Triangles where they are now.
struct NewCrossings::Leaf
{
  std::size_t First = 0;
  std::size_t Last = 0;
  std::array<PlaneTriangle, LeafSize> Triangles;
};

NewCrossings::NewCrossings(const Surface& before, Times times, int threads)
  : Before(before)
  , Checked(times)
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
  this->TriangleBoxes.resize(this->Before.Triangles.size());
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
  const std::size_t count = this->Before.Triangles.size();
  ForEachId((count + LeafSize - 1) / LeafSize, this->Threads,
    [&](std::size_t leaf)
    {
      Box& box = this->Boxes[this->Leaves + leaf];
      for (std::size_t t = LeafSize * leaf; t < std::min(count, LeafSize * (leaf + 1)); ++t)
      {
        const Triangle& c = this->Before.Triangles[t];
        this->TriangleBoxes[t] = boxOf(points, c);
        if (this->Checked == Times::All)
        {
          join(this->TriangleBoxes[t], boxOf(this->Before.Points, c));
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
/// The leaf itself and those whose boxes overlap its box: the later ones, or all.
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
  const Vector3 before = areaOf(this->Before.Points);
  return before.squaredNorm() > 0.0 && !(Dot(before, areaOf(points)) > 0.0);
}

/// Whether two triangles that intersect now or have passed through each other did not before. Those
/// that only touched may touch, but not pierce each other.
bool NewCrossings::IsNew(const Pair& now, std::size_t a, std::size_t b) const
{
  const Triangle& first = this->Before.Triangles[a];
  const Triangle& second = this->Before.Triangles[b];
  const CommonCorners common(first, second);
  const bool isWatched = this->Checked == Times::All && common.Count == 0;
  const bool intersect = Intersect(now.First, now.Second, common);
  if (!intersect && !isWatched)
  {
    return false;
  }
  const PlaneTriangle firstBefore = PlaneTriangleOf(this->Before.Points, first);
  const PlaneTriangle secondBefore = PlaneTriangleOf(this->Before.Points, second);
  if (Intersect(firstBefore, secondBefore, common))
  {
    return intersect && Pierce(now.First, now.Second) && !Pierce(firstBefore, secondBefore);
  }
  return intersect ||
    !StayApart(
      { firstBefore.Corners, secondBefore.Corners }, { now.First.Corners, now.Second.Corners });
}

//------------------------------------------------------------------------------
/// Pairs of a moved triangle of the leaf; of two moved ones the pair with the lesser in this leaf.
void NewCrossings::FindOfLeaf(std::size_t leaf, const Query& query, std::vector<Index>& found) const
{
  const std::size_t first = LeafSize * leaf;
  const std::size_t last = std::min(this->Before.Triangles.size(), first + LeafSize);
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
    own.Triangles[t - first] = PlaneTriangleOf(query.Points, this->Before.Triangles[t]);
    if (query.IsMoved[t] != 0 && this->IsTurnedOver(query.Points, this->Before.Triangles[t]))
    {
      found.push_back(static_cast<Index>(t));
    }
  }
  for (const std::size_t near : leaves)
  {
    const std::size_t end = std::min(this->Before.Triangles.size(), LeafSize * (near + 1));
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
/// Pairs of a triangle and moved triangles of the leaf.
void NewCrossings::FindOfTriangle(
  std::size_t u, const Leaf& leaf, const Query& query, std::vector<Index>& found) const
{
  std::optional<PlaneTriangle> other;
  for (std::size_t t = leaf.First; t < leaf.Last; ++t)
  {
    const bool isOfThisLeaf = query.IsMoved[t] != 0 && (query.IsMoved[u] == 0 || t < u);
    if (isOfThisLeaf && this->TriangleBoxes[t].Overlaps(this->TriangleBoxes[u]))
    {
      if (!other)
      {
        other = PlaneTriangleOf(query.Points, this->Before.Triangles[u]);
      }
      if (this->IsNew({ leaf.Triangles[t - leaf.First], *other }, t, u))
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
  const std::size_t leaves = (this->Before.Triangles.size() + LeafSize - 1) / LeafSize;
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
