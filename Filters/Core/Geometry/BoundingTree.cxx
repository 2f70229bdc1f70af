// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundingTree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace bonedecimate
{
namespace
{
constexpr Index LeafSize = 4;
/// The halves differ by one at most, so 2^31 triangles are 29 levels above the leaves.
constexpr std::size_t LargestDepth = 64;
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// A box may seem farther than the triangle in it by rounding; with this a hint never changes the answer.
constexpr double Slack = 1.0 + 1e-12;
}

BoundingTree::BoundingTree(const Surface& surface)
{
  const Index count = static_cast<Index>(surface.Triangles.size());
  std::vector<Vector3> middles(surface.Triangles.size());
  std::vector<Index> order(surface.Triangles.size());
  std::iota(order.begin(), order.end(), 0);
  this->Slots.resize(surface.Triangles.size());
  this->SlotOfTriangle.resize(surface.Triangles.size());
  for (std::size_t t = 0; t < middles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    middles[t] =
      surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]];
  }
  if (count > 0)
  {
    this->Nodes.reserve(surface.Triangles.size());
    this->Build(order, middles, 0, count);
  }
  for (std::size_t slot = 0; slot < order.size(); ++slot)
  {
    const Triangle& points = surface.Triangles[order[slot]];
    this->Slots[slot] = { { surface.Points[points[0]], surface.Points[points[1]],
                            surface.Points[points[2]] },
      points, order[slot] };
    this->SlotOfTriangle[order[slot]] = static_cast<Index>(slot);
  }
  // Children stand behind their parents, so that boxes are filled from the back.
  for (std::size_t node = this->Nodes.size(); node-- > 0;)
  {
    this->Bound(this->Nodes[node]);
  }
}

//------------------------------------------------------------------------------
void BoundingTree::Build(
  std::vector<Index>& order, const std::vector<Vector3>& middles, Index first, Index last)
{
  const std::size_t self = this->Nodes.size();
  this->Nodes.emplace_back();
  if (last - first <= LeafSize)
  {
    this->Nodes[self].First = first;
    this->Nodes[self].Count = last - first;
    return;
  }
  Vector3 low = middles[order[first]];
  Vector3 high = low;
  for (Index i = first + 1; i < last; ++i)
  {
    low = low.cwiseMin(middles[order[i]]);
    high = high.cwiseMax(middles[order[i]]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const Index middle = first + (last - first) / 2;
  std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
    [&](Index a, Index b)
    { return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b; });
  this->Build(order, middles, first, middle);
  this->Nodes[self].First = static_cast<Index>(this->Nodes.size());
  this->Build(order, middles, middle, last);
}

//------------------------------------------------------------------------------
void BoundingTree::Bound(Node& node) const
{
  if (node.Count == 0)
  {
    const Node& left = *(&node + 1);
    const Node& right = this->Nodes[node.First];
    node.Low = left.Low.cwiseMin(right.Low);
    node.High = left.High.cwiseMax(right.High);
    return;
  }
  node.Low = Vector3::Constant(Infinity);
  node.High = Vector3::Constant(-Infinity);
  for (Index slot = node.First; slot < node.First + node.Count; ++slot)
  {
    for (const Vector3& corner : this->Slots[slot].Corners)
    {
      node.Low = node.Low.cwiseMin(corner);
      node.High = node.High.cwiseMax(corner);
    }
  }
}

//------------------------------------------------------------------------------
double BoundingTree::SquaredDistanceToBox(const Node& node, const Vector3& p)
{
  return (node.Low - p).cwiseMax(p - node.High).cwiseMax(0.0).squaredNorm();
}

//------------------------------------------------------------------------------
template <typename Limit, typename Visit>
void BoundingTree::Walk(const Vector3& p, Limit limit, Visit visit) const
{
  struct Waiting
  {
    Index Node;
    double SquaredDistance;
  };
  std::array<Waiting, LargestDepth> stack;
  std::size_t size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = { 0, SquaredDistanceToBox(this->Nodes[0], p) };
  }
  while (size > 0)
  {
    const Waiting waiting = stack[--size];
    if (waiting.SquaredDistance > Slack * limit())
    {
      continue;
    }
    const Node& node = this->Nodes[waiting.Node];
    if (node.Count > 0)
    {
      for (Index slot = node.First; slot < node.First + node.Count; ++slot)
      {
        visit(this->Slots[slot]);
      }
      continue;
    }
    Waiting near = { waiting.Node + 1, SquaredDistanceToBox(this->Nodes[waiting.Node + 1], p) };
    Waiting far = { node.First, SquaredDistanceToBox(this->Nodes[node.First], p) };
    if (far.SquaredDistance < near.SquaredDistance)
    {
      std::swap(near, far);
    }
    stack[size++] = far;
    stack[size++] = near;
  }
}

//------------------------------------------------------------------------------
BoundingTree::Nearest BoundingTree::FindNearest(const Vector3& p, Index hintTriangle) const
{
  Nearest best;
  best.Place.SquaredDistance = Infinity;
  const auto visit = [&](const Slot& slot)
  {
    const TrianglePlace place =
      NearestOnTriangle(p, slot.Corners[0], slot.Corners[1], slot.Corners[2]);
    const double previous = best.Place.SquaredDistance;
    if (place.SquaredDistance < previous ||
      (place.SquaredDistance == previous && slot.Id < best.Triangle))
    {
      best = { slot.Id, place };
    }
  };
  if (hintTriangle != None)
  {
    visit(this->Slots[this->SlotOfTriangle[hintTriangle]]);
  }
  this->Walk(
    p, [&] { return best.Place.SquaredDistance; }, visit);
  return best;
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
      const double distance = (p - slot.Corners[i]).squaredNorm();
      if (distance < squaredDistance || (distance == squaredDistance && slot.Points[i] < best))
      {
        best = slot.Points[i];
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
}
