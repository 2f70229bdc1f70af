// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundingTree.h
 * @brief Nearest place on a set of triangles, exactly, by a tree of axis-aligned boxes.
 *
 * The answer is the least distance and, among equals, the least triangle id; a hint changes the time, not the answer.
 */
#ifndef BoneDecimate_Core_Geometry_BoundingTree_h
#define BoneDecimate_Core_Geometry_BoundingTree_h

#include "Surface.h"
#include "TriangleGeometry.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class BoundingTree
{
public:
  /// Copies what it needs. Corners must be valid and finite.
  explicit BoundingTree(const Surface& surface);

  struct Nearest
  {
    Index Triangle = None;
    TrianglePlace Place;
  };

  /// The nearest place on any triangle; Triangle is None only if there are no triangles.
  Nearest FindNearest(const Vector3& p, Index hintTriangle = None) const;

  /// The nearest corner of any triangle, as a point id; None only if there are no triangles.
  Index FindNearestPoint(const Vector3& p, Index hintTriangle = None) const;

private:
  struct Node
  {
    Vector3 Low, High; // mm
    Index First =
      0; // leaf: first slot; inner: index of the second child, the first one follows its parent
    Index Count = 0; // leaf: number of slots; inner: 0
  };
  struct Slot
  {
    std::array<Vector3, 3> Corners; // mm
    Triangle Points;
    Index Id = None;
  };

  void Build(
    std::vector<Index>& order, const std::vector<Vector3>& middles, Index first, Index last);
  void Bound(Node& node) const;
  static double SquaredDistanceToBox(const Node& node, const Vector3& p);

  /// Visits the slots whose boxes are not farther than `limit()` (mm^2), nearer boxes first.
  template <typename Limit, typename Visit>
  void Walk(const Vector3& p, Limit limit, Visit visit) const;

  std::vector<Node> Nodes;
  std::vector<Slot> Slots;
  std::vector<Index> SlotOfTriangle;
};
}

#endif
