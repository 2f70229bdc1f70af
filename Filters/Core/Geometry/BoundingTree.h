// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundingTree.h
 * @brief Nearest place on a set of triangles, exactly, by a tree of axis-aligned boxes.
 *
 * The answer is the least distance and, among equals, the least triangle id; a hint changes the time, not the answer.
 *
 *     build:  level after level, each range of triangles is halved twice at the median of their middles, along the
 *             longer side; halves are multiples of four, so that nearly every last node holds four triangles
 *     ask:    nearest box first; boxes of single precision, a little too large, four at a time;
 *             what is in them is measured in double precision
 *
 * I. Wald, C. Benthin, S. Boulos, Getting rid of packets: efficient SIMD single-ray traversal using multi-branching
 * BVHs, 2008: four boxes a node.
 */
#ifndef BoneDecimate_Core_Geometry_BoundingTree_h
#define BoneDecimate_Core_Geometry_BoundingTree_h

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
  /// Copies what it needs. Corners must be valid and finite. The same tree whatever the number of threads.
  /// @param afterStep Called on the calling thread after each of many steps.
  explicit BoundingTree(
    const Surface& surface, int threads = 1, const std::function<void()>& afterStep = {});

  struct Nearest
  {
    Index Triangle = None;
    TrianglePlace Place;
  };

  /// The nearest place on any triangle; Triangle is None only if there are no triangles.
  Nearest FindNearest(const Vector3& p, Index hintTriangle = None) const;

  /// The nearest corner of any triangle, as a point id; None only if there are no triangles.
  Index FindNearestPoint(const Vector3& p, Index hintTriangle = None) const;

  /// Calls visit(triangle) for every triangle whose box reaches within the distance, nearer boxes first.
  /// @param squaredDistance mm^2; visit may make it smaller.
  void VisitNear(
    const Vector3& p, const double& squaredDistance, const std::function<void(Index)>& visit) const;

private:
  /// Four children with their boxes side by side, in the tree's own unit (see ToUnit) and a little too large.
  struct Node
  {
    std::array<std::array<float, 4>, 3> Low, High; // by axis and child; Low > High: no child
    std::array<Index, 4> Children;                 // a node, or ~slot of a triangle
  };
  struct Slot
  {
    std::array<Vector3, 3> Corners; // mm
    Triangle Points;
    Index Id = None;
  };
  class Builder;

  void SetUnit(const Surface& surface);
  float ToUnit(double coordinate, Eigen::Index axis, double side) const;
  void Bound(Node& node) const;

  /// Visits the slots whose boxes are not farther than `limit()` (mm^2), nearer boxes first.
  template <typename Limit, typename Visit>
  void Walk(const Vector3& p, Limit limit, Visit visit) const;

  std::vector<Node> Nodes; // level after level, the root first
  std::vector<Slot> Slots;
  std::vector<Index> SlotOfTriangle;
  Vector3 Low = Vector3::Zero(); // mm
  double Scale = 1.0;            // 1/mm; the longest side of everything is 1 then
};
}

#endif
