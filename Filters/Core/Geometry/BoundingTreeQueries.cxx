// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundingTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// A child has little more than a quarter of the triangles of its parent, so 2^31 triangles need 17
/// levels.
constexpr std::size_t MaxStack = 128;
/// A distance or squared distance to a box in single precision is too large by less than this
/// factor.
constexpr double Slack = 1.0 + 1e-5;
constexpr double MaxSquare = 1e38;

/// The query point in the unit of the tree.
struct QueryPoint
{
  std::array<float, 3> Low, High; // bounds of its coordinates
};

/// Squared distances to four boxes. Uses x + |x|, twice the maximum of x and 0, because gcc 12 does
/// not vectorize maxima. At most one of the distances below and above a box is positive.
template <typename Boxes>
std::array<float, 4> SquaredDistances(const QueryPoint& query, const Boxes& boxes)
{
  std::array<float, 4> sum = { 0.0F, 0.0F, 0.0F, 0.0F };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::array<float, 4> twice;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const float below = boxes.Low[axis][i] - query.High[axis];
      const float above = query.Low[axis] - boxes.High[axis][i];
      twice[i] = (below + std::abs(below)) + (above + std::abs(above));
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      sum[i] += 0.25F * twice[i] * twice[i];
    }
  }
  return sum;
}

/// A ray in the unit of the tree.
struct Ray
{
  std::array<double, 3> From, Inverse; // Inverse: 1 / direction, or large

  Ray(const Vector3& from, const Vector3& direction)
  {
    constexpr double least = 1e-30;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double along = direction[static_cast<Eigen::Index>(axis)];
      this->From[axis] = from[static_cast<Eigen::Index>(axis)];
      this->Inverse[axis] = 1.0 / (std::abs(along) < least ? least : along);
    }
  }
};

/// The length at which the ray enters each of four boxes; infinite if it misses the box.
template <typename Boxes>
std::array<float, 4> EntriesOf(const Ray& ray, const Boxes& boxes)
{
  std::array<float, 4> entries;
  for (std::size_t i = 0; i < 4; ++i)
  {
    double enters = 0.0;
    double leaves = Infinity;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double inverse = ray.Inverse[axis];
      const double low = (boxes.Low[axis][i] - ray.From[axis]) * inverse;
      const double high = (boxes.High[axis][i] - ray.From[axis]) * inverse;
      enters = std::max(enters, inverse > 0.0 ? low : high);
      leaves = std::min(leaves, inverse > 0.0 ? high : low);
    }
    entries[i] = static_cast<float>(enters <= leaves ? enters : Infinity);
  }
  return entries;
}
}

//------------------------------------------------------------------------------
template <typename Distances, typename Farthest, typename ToBox, typename Visit>
void BoundingTree::Descend(
  Distances distancesTo, Farthest farthest, ToBox distanceTo, Visit visit) const
{
  struct Waiting
  {
    float Distance;
    Index Child;
  };
  std::array<Waiting, MaxStack> stack;
  std::size_t size = 0;
  float most = farthest();
  if (!this->Nodes.empty())
  {
    stack[size++] = { 0.0F, 0 };
  }
  while (size > 0)
  {
    const Waiting waiting = stack[--size];
    if (waiting.Distance > most)
    {
      continue;
    }
    if (waiting.Child < 0)
    {
      visit(this->Slots[~waiting.Child]);
      most = farthest();
      continue;
    }
    const Node& node = this->Nodes[waiting.Child];
    std::array<float, 4> distances = distancesTo(node);
    for (std::size_t child = 0; child < 4 && node.HasBox != 0; ++child)
    {
      if ((node.HasBox >> child & 1U) != 0)
      {
        const OrientedBox& box = this->Boxes[this->Nodes[node.Children[child]].Box];
        distances[child] = std::max(distances[child], static_cast<float>(distanceTo(box)));
      }
    }
    const std::size_t base = size; // children are inserted above it, the nearest last
    for (std::size_t child = 0; child < 4; ++child)
    {
      if (distances[child] <= most)
      {
        std::size_t at = size++;
        for (; at > base && stack[at - 1].Distance < distances[child]; --at)
        {
          stack[at] = stack[at - 1];
        }
        stack[at] = { distances[child], node.Children[child] };
      }
    }
  }
}

//------------------------------------------------------------------------------
template <typename Limit, typename Visit>
void BoundingTree::Walk(const Vector3& p, Limit limit, Visit visit) const
{
  QueryPoint query;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    query.Low[static_cast<std::size_t>(axis)] = this->ToUnit(p[axis], axis, -1.0);
    query.High[static_cast<std::size_t>(axis)] = this->ToUnit(p[axis], axis, 1.0);
  }
  const auto farthest = [&]
  {
    const double square = limit() * this->Scale * this->Scale * Slack;
    return static_cast<float>(std::min(square, MaxSquare));
  };
  this->Descend([&](const Node& node) { return SquaredDistances(query, node); }, farthest,
    [&](const OrientedBox& box) { return box.SquaredDistance(p) * this->Scale * this->Scale; },
    visit);
}

//------------------------------------------------------------------------------
BoundingTree::Nearest BoundingTree::FindNearest(const Vector3& p, Index hintTriangle) const
{
  Nearest best;
  best.Point.SquaredDistance = Infinity;
  if (hintTriangle != None)
  {
    Improve(p, this->Slots[this->SlotOfTriangle[hintTriangle]], best);
  }
  this->Improve(p, best);
  return best;
}

//------------------------------------------------------------------------------
BoundingTree::Nearest BoundingTree::FindNearestWithin(
  const Vector3& p, double squaredDistance) const
{
  Nearest best;
  best.Point.SquaredDistance = squaredDistance;
  this->Improve(p, best);
  return best;
}

//------------------------------------------------------------------------------
void BoundingTree::Improve(const Vector3& p, Nearest& best) const
{
  this->Walk(
    p, [&best] { return best.Point.SquaredDistance; },
    [&](const Slot& slot) { Improve(p, slot, best); });
}

//------------------------------------------------------------------------------
void BoundingTree::Improve(const Vector3& p, const Slot& slot, Nearest& best) const
{
  const PointOnTriangle point = NearestOnTriangle(
    p, this->Points[slot.Corners[0]], this->Points[slot.Corners[1]], this->Points[slot.Corners[2]]);
  const double previous = best.Point.SquaredDistance;
  if (point.SquaredDistance < previous ||
    (point.SquaredDistance == previous && slot.Id < best.Triangle))
  {
    best = { slot.Id, point };
  }
}

//------------------------------------------------------------------------------
Index BoundingTree::FindNearestPoint(const Vector3& p, Index hintTriangle) const
{
  Index best = None;
  double squaredDistance = Infinity;
  const auto visit = [&](const Slot& slot)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double distance = (p - this->Points[slot.Corners[i]]).squaredNorm();
      if (distance < squaredDistance || (distance == squaredDistance && slot.Corners[i] < best))
      {
        best = slot.Corners[i];
        squaredDistance = distance;
      }
    }
  };
  if (hintTriangle != None)
  {
    visit(this->Slots[this->SlotOfTriangle[hintTriangle]]);
  }
  this->Walk(
    p, [&] { return squaredDistance; }, visit);
  return best;
}

//------------------------------------------------------------------------------
void BoundingTree::VisitNear(
  const Vector3& p, const double& squaredDistance, const std::function<void(Index)>& visit) const
{
  this->Walk(
    p, [&] { return squaredDistance; }, [&](const Slot& slot) { visit(slot.Id); });
}

//------------------------------------------------------------------------------
void BoundingTree::VisitAlong(const Vector3& from, const Vector3& direction, const double& length,
  const std::function<void(Index)>& visit) const
{
  const Ray ray((from - this->Low) * this->Scale, direction);
  const auto farthest = [&]
  { return static_cast<float>(std::min(length * this->Scale * Slack, MaxSquare)); };
  this->Descend([&](const Node& node) { return EntriesOf(ray, node); }, farthest,
    [&](const OrientedBox& box) { return box.EntryOf(from, direction) * this->Scale; },
    [&](const Slot& slot) { visit(slot.Id); });
}
}
