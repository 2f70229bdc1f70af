// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundingTree.h
 * @brief Exact nearest-point queries on a set of triangles, by a tree of axis-aligned boxes.
 *
 * A query finds the smallest distance and, among equal ones, the smallest triangle id. A hint
 * changes the time but never the result.
 *
 *     build:  level by level, halve each range of triangles twice, at the median of the centroids
 *             along the longer side; halves are multiples of four, so that nearly every leaf
 *             holds four triangles
 *             give nodes of parallel needles an oriented box, too: the axis-aligned boxes of
 *             needles that meet in one point overlap
 *     query:  nearest box first; four boxes per node, in single precision and slightly enlarged;
 *             distances to triangles in double precision
 *
 * I. Wald, C. Benthin, S. Boulos, Getting rid of packets: efficient SIMD single-ray traversal using
 * multi-branching BVHs, 2008: four boxes per node.
 */
#ifndef BoneDecimate_Core_Geometry_BoundingTree_h
#define BoneDecimate_Core_Geometry_BoundingTree_h

#include "OrientedBox.h"
#include "Surface.h"
#include "TriangleGeometry.h"

#include <array>
#include <functional>
#include <vector>

namespace bonedecimate
{
class BoundingTree
{
public:
  /// Copies points and triangles. Corners must be valid and finite. The tree does not depend on the
  /// number of threads.
  /// @param afterStep Called on the calling thread after each step.
  explicit BoundingTree(
    const Surface& surface, int threads = 1, const std::function<void()>& afterStep = {});

  struct Nearest
  {
    Index Triangle = None;
    PointOnTriangle Point;
  };

  /// The nearest point on any triangle. Triangle is None only if there are no triangles.
  Nearest FindNearest(const Vector3& p, Index hintTriangle = None) const;

  /// The same within a distance; Triangle is None if no triangle is that near.
  Nearest FindNearestWithin(const Vector3& p, double squaredDistance) const;

  /// The nearest corner of any triangle, as a point id; None only if there are no triangles.
  Index FindNearestPoint(const Vector3& p, Index hintTriangle = None) const;

  /// Calls visit(triangle) for every triangle whose box is within the distance, nearer boxes first.
  /// @param squaredDistance mm^2; visit may decrease it.
  void VisitNear(
    const Vector3& p, const double& squaredDistance, const std::function<void(Index)>& visit) const;

  /// Calls visit(triangle) for every triangle whose box the ray meets within the length, nearer
  /// boxes first.
  /// @param direction A vector of length 1.  @param length mm; visit may decrease it.
  void VisitAlong(const Vector3& from, const Vector3& direction, const double& length,
    const std::function<void(Index)>& visit) const;

private:
  /// Four children with their boxes, in the unit of the tree (ToUnit) and slightly enlarged.
  struct Node
  {
    std::array<std::array<float, 4>, 3> Low, High; // by axis and child; Low > High: no child
    std::array<Index, 4> Children;                 // a node, or the complement of a slot
    Index Box = None;                              // its oriented box, in Boxes
    unsigned HasBox = 0;                           // bit i: child i has an oriented box
  };
  struct Slot
  {
    Triangle Corners; // points
    Index Id = None;
  };
  class Builder;

  void SetUnit(const Surface& surface);
  float ToUnit(double coordinate, Eigen::Index axis, double side) const;
  void Bound(Node& node) const;

  /// Visits the slots whose boxes are within `farthest()`, nearer boxes first.
  /// @param distancesTo The distances to the four children of a node, each too large by Slack at
  /// most.
  /// @param distanceTo The distance to an oriented box, likewise.
  template <typename Distances, typename Farthest, typename ToBox, typename Visit>
  void Descend(Distances distancesTo, Farthest farthest, ToBox distanceTo, Visit visit) const;

  void Improve(const Vector3& p, Nearest& best) const;
  void Improve(const Vector3& p, const Slot& slot, Nearest& best) const;

  /// Visits the slots whose boxes are within `limit()` (squared, mm^2), nearer boxes first.
  template <typename Limit, typename Visit>
  void Walk(const Vector3& p, Limit limit, Visit visit) const;

  std::vector<Vector3> Points; // mm
  std::vector<Node> Nodes;     // level after level, the root first
  std::vector<Slot> Slots;
  std::vector<Index> SlotOfTriangle;
  std::vector<OrientedBox> Boxes; // oriented boxes of nodes
  Vector3 Low = Vector3::Zero();  // mm
  double Scale = 1.0;             // 1/mm; scales the longest side of the whole to 1
};
}

#endif
