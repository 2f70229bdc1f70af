// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FragmentTree.h"

#include "FloatBox.h"
#include "Geometry/TriangleFrame.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr Index TrianglesPerLeaf = 4;
/// A little less than the square of MinFacingCosine.
constexpr double SquaredCosine = 0.99 * MinFacingCosine * MinFacingCosine;

float Below(double x)
{
  return std::nextafter(static_cast<float>(x), -FloatInfinity);
}
float Above(double x)
{
  return std::nextafter(static_cast<float>(x), FloatInfinity);
}

double SquaredGap(double below, double above)
{
  const double gap = std::max({ below, above, 0.0 });
  return gap * gap;
}
}

FragmentTree::FragmentTree(const Surface& surface, const Components& fragments)
  : Source(surface)
  , Fragments(fragments)
  , Leaves(1)
{
  while (this->Leaves * TrianglesPerLeaf < surface.Triangles.size())
  {
    this->Leaves *= 2;
  }
  this->Nodes.resize(2 * this->Leaves);
  for (std::size_t leaf = 0; leaf < this->Leaves; ++leaf)
  {
    this->FillLeaf(leaf);
  }
  for (std::size_t node = this->Leaves; --node > 0;)
  {
    this->Join(node);
  }
}

//------------------------------------------------------------------------------
/// The triangles are distributed evenly over the leaves.
Index FragmentTree::FirstOf(std::size_t leaf) const
{
  return static_cast<Index>(
    std::uint64_t(leaf) * this->Source.Triangles.size() / this->Leaves); // 32 bits overflow
}

//------------------------------------------------------------------------------
Index FragmentTree::FragmentOf(Index triangle) const
{
  return this->Fragments.OfPoint[this->Source.Triangles[triangle][0]];
}

//------------------------------------------------------------------------------
TriangleCorners FragmentTree::CornersOf(Index triangle) const
{
  const Triangle& c = this->Source.Triangles[triangle];
  return { this->Source.Points[c[0]], this->Source.Points[c[1]], this->Source.Points[c[2]] };
}

//------------------------------------------------------------------------------
void FragmentTree::FillLeaf(std::size_t leaf)
{
  Node& node = this->Nodes[this->Leaves + leaf];
  node.Low.fill(FloatInfinity);
  node.High.fill(-FloatInfinity);
  node.MinNormal = node.Low;
  node.MaxNormal = node.High;
  node.MinFragment = std::numeric_limits<Index>::max();
  node.MaxFragment = None;
  for (Index t = this->FirstOf(leaf); t < this->FirstOf(leaf + 1); ++t)
  {
    const TriangleCorners p = this->CornersOf(t);
    const Vector3 normal = AreaVector(p[0], p[1], p[2]).normalized();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto at = static_cast<Eigen::Index>(axis);
      node.Low[axis] = std::min(node.Low[axis], Below(std::min({ p[0][at], p[1][at], p[2][at] })));
      node.High[axis] =
        std::max(node.High[axis], Above(std::max({ p[0][at], p[1][at], p[2][at] })));
      node.MinNormal[axis] = std::min(node.MinNormal[axis], Below(normal[at]));
      node.MaxNormal[axis] = std::max(node.MaxNormal[axis], Above(normal[at]));
    }
    node.MinFragment = std::min(node.MinFragment, this->FragmentOf(t));
    node.MaxFragment = std::max(node.MaxFragment, this->FragmentOf(t));
  }
}

//------------------------------------------------------------------------------
void FragmentTree::Join(std::size_t node)
{
  Node& both = this->Nodes[node];
  const Node& a = this->Nodes[2 * node];
  const Node& b = this->Nodes[2 * node + 1];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    both.Low[axis] = std::min(a.Low[axis], b.Low[axis]);
    both.High[axis] = std::max(a.High[axis], b.High[axis]);
    both.MinNormal[axis] = std::min(a.MinNormal[axis], b.MinNormal[axis]);
    both.MaxNormal[axis] = std::max(a.MaxNormal[axis], b.MaxNormal[axis]);
  }
  both.MinFragment = std::min(a.MinFragment, b.MinFragment);
  both.MaxFragment = std::max(a.MaxFragment, b.MaxFragment);
}

//------------------------------------------------------------------------------
double FragmentTree::SquaredDistance(const Node& node, const Vector3& p)
{
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double at = p[static_cast<Eigen::Index>(axis)];
    sum += SquaredGap(node.Low[axis] - at, at - node.High[axis]);
  }
  return sum;
}

//------------------------------------------------------------------------------
double FragmentTree::SquaredDistance(const Node& a, const Node& b)
{
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    sum += SquaredGap(static_cast<double>(a.Low[axis]) - b.High[axis],
      static_cast<double>(b.Low[axis]) - a.High[axis]);
  }
  return sum;
}

//------------------------------------------------------------------------------
/// Visits the triangles of all wanted leaves within the limit, near leaves first. The limit may
/// fall meanwhile.
template <typename Wants, typename Visit>
void FragmentTree::Walk(
  const Vector3& p, const double& squaredLimit, const Wants& wants, const Visit& visit) const
{
  struct Open
  {
    std::size_t Node;
    double Squared; // mm^2, from p
  };
  std::array<Open, 64> stack;
  std::size_t size = 0;
  stack[size++] = { 1, SquaredDistance(this->Nodes[1], p) };
  while (size > 0)
  {
    const auto [at, squared] = stack[--size];
    if (squared >= squaredLimit || !wants(this->Nodes[at], squared))
    {
      continue;
    }
    if (at < this->Leaves)
    {
      const Open first = { 2 * at, SquaredDistance(this->Nodes[2 * at], p) };
      const Open second = { 2 * at + 1, SquaredDistance(this->Nodes[2 * at + 1], p) };
      const bool isFirstNear = first.Squared <= second.Squared;
      stack[size++] = isFirstNear ? second : first;
      stack[size++] = isFirstNear ? first : second;
      continue;
    }
    for (Index t = this->FirstOf(at - this->Leaves); t < this->FirstOf(at - this->Leaves + 1); ++t)
    {
      visit(t);
    }
  }
}

//------------------------------------------------------------------------------
double FragmentTree::DistanceToOther(const Vector3& p, Index fragment, double limit) const
{
  double squared = limit * limit;
  this->Walk(
    p, squared,
    [fragment](const Node& node, double)
    { return node.MinFragment != fragment || node.MaxFragment != fragment; },
    [&](Index t)
    {
      if (this->FragmentOf(t) != fragment)
      {
        const TriangleCorners c = this->CornersOf(t);
        squared = std::min(squared, TriangleFrame(c[0], c[1], c[2]).SquaredReach(p));
      }
    });
  return std::sqrt(squared);
}

//------------------------------------------------------------------------------
/// Whether a triangle in the box may have a normal opposed to that of the point, and lie in the
/// double cone around it.
/// @param squaredDistance mm^2, from the point to the box.
bool FragmentTree::MayFace(
  const Node& node, double squaredDistance, const Vector3& p, const Vector3& normal)
{
  double minProduct = 0.0;               // of the normals
  double minAlong = 0.0, maxAlong = 0.0; // mm, from the point along its normal
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double n = normal[static_cast<Eigen::Index>(axis)];
    const double low = n * (node.Low[axis] - p[static_cast<Eigen::Index>(axis)]);
    const double high = n * (node.High[axis] - p[static_cast<Eigen::Index>(axis)]);
    minProduct += std::min(n * node.MinNormal[axis], n * node.MaxNormal[axis]);
    minAlong += std::min(low, high);
    maxAlong += std::max(low, high);
  }
  const double farthest = std::max(-minAlong, maxAlong);
  return minProduct < 0.0 && farthest * farthest >= SquaredCosine * squaredDistance;
}

//------------------------------------------------------------------------------
double FragmentTree::DistanceToFacing(Index point, const Vector3& normal, double limit) const
{
  const Vector3& p = this->Source.Points[point];
  const Index fragment = this->Fragments.OfPoint[point];
  double squared = limit * limit;
  this->Walk(
    p, squared,
    [&](const Node& node, double squaredDistance)
    {
      return node.MinFragment <= fragment && node.MaxFragment >= fragment &&
        MayFace(node, squaredDistance, p, normal);
    },
    [&](Index t)
    {
      const Triangle& v = this->Source.Triangles[t];
      const bool isOwn = v[0] == point || v[1] == point || v[2] == point;
      const auto& [a, b, c] = this->CornersOf(t);
      if (isOwn || this->FragmentOf(t) != fragment || Dot(AreaVector(a, b, c), normal) > 0.0)
      {
        return;
      }
      const TriangleFrame frame(a, b, c);
      if (Dot(frame.UnitNormal(), normal) < 0.0)
      {
        const Vector3 way = frame.At(frame.Nearest(p)) - p;
        squared = FaceEachOther(normal, frame.UnitNormal(), way)
          ? std::min(squared, way.squaredNorm())
          : squared;
      }
    });
  return std::sqrt(squared);
}

//------------------------------------------------------------------------------
double FragmentTree::MinBetween(std::size_t leafA, std::size_t leafB, double squaredLimit) const
{
  for (Index a = this->FirstOf(leafA); a < this->FirstOf(leafA + 1); ++a)
  {
    for (Index b = this->FirstOf(leafB); b < this->FirstOf(leafB + 1); ++b)
    {
      if (this->FragmentOf(a) != this->FragmentOf(b))
      {
        const TriangleCorners cornersA = this->CornersOf(a);
        const TriangleCorners cornersB = this->CornersOf(b);
        const bool meet = Meet(PlaneTriangle(cornersA), PlaneTriangle(cornersB));
        const double squared = meet ? 0.0 : ShortestConnection(cornersA, cornersB).SquaredLength;
        squaredLimit = std::min(squaredLimit, squared);
      }
    }
  }
  return squaredLimit;
}

//------------------------------------------------------------------------------
double FragmentTree::MinFragmentGap() const
{
  double squared = Infinity;
  std::vector<std::array<std::size_t, 2>> open = { { 1, 1 } };
  while (!open.empty())
  {
    const auto [a, b] = open.back();
    open.pop_back();
    const Node& nodeA = this->Nodes[a];
    const Node& nodeB = this->Nodes[b];
    const bool isOneFragment =
      nodeA.MinFragment == nodeB.MaxFragment && nodeA.MaxFragment == nodeB.MinFragment;
    if (isOneFragment || SquaredDistance(nodeA, nodeB) >= squared)
    {
      continue;
    }
    if (a >= this->Leaves)
    {
      squared = this->MinBetween(a - this->Leaves, b - this->Leaves, squared);
      continue;
    }
    std::array<std::array<std::size_t, 2>, 4> pairs = { { { 2 * a, 2 * b }, { 2 * a, 2 * b + 1 },
      { 2 * a + 1, 2 * b + 1 }, { 2 * a + 1, 2 * b } } };
    const std::size_t count = a == b ? 3 : 4; // of a node with itself, each pair once
    std::sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count),
      [this](const auto& p, const auto& q)
      {
        return SquaredDistance(this->Nodes[p[0]], this->Nodes[p[1]]) >
          SquaredDistance(this->Nodes[q[0]], this->Nodes[q[1]]);
      });
    open.insert(open.end(), pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return std::sqrt(squared);
}
}
