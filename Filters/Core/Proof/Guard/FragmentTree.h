// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FragmentTree.h
 * @brief Distance of a point to what faces it across a gap: another fragment, the other side of a
 * fracture or of a thin plate.
 *
 *     faces:   triangle t faces the point x across the vector d if n_x and -n_t both point
 *              along d, or both against it, within 45 degrees: across empty space or bone
 *     node:    a box, a box of the normals, and the least and the greatest fragment number
 *     skip:    nodes farther than the nearest triangle so far
 *              other fragments:  nodes of the point's own fragment
 *              facing:           nodes without a normal opposed to that of the point, and nodes
 *                                outside of the double cone around it
 *
 * A binary tree over the triangles in their order, which is that of a space-filling curve.
 */
#ifndef BoneDecimate_Core_Proof_Guard_FragmentTree_h
#define BoneDecimate_Core_Proof_Guard_FragmentTree_h

#include "Mesh/Statistics.h"
#include "TrianglePair.h"

#include <vector>

namespace bonedecimate
{
/// Cosine of the largest angle between a normal and the vector across a gap.
constexpr double MinFacingCosine = 0.7;

/// Whether two points with these unit normals face each other across the vector between them (mm).
inline bool FaceEachOther(const Vector3& normalA, const Vector3& normalB, const Vector3& way)
{
  const double minAlong = MinFacingCosine * way.norm();
  const double alongA = Dot(normalA, way);
  const double alongB = Dot(normalB, way);
  return Dot(normalA, normalB) < 0.0 &&
    ((alongA > minAlong && alongB < -minAlong) || (alongA < -minAlong && alongB > minAlong));
}

class FragmentTree
{
public:
  /// Both must outlive this object. Points must be finite, triangles must have area.
  FragmentTree(const Surface& surface, const Components& fragments);

  /// mm, from a point of a fragment to the nearest other fragment; the limit if none is nearer.
  double DistanceToOther(const Vector3& p, Index fragment, double limit) const;

  /// mm, from a point of the surface to the nearest triangle of its fragment that faces it, its own
  /// triangles excluded; the limit if none is nearer.
  double DistanceToFacing(Index point, const Vector3& normal, double limit) const;

  /// mm, the least distance between two fragments; infinite if there is only one.
  double MinFragmentGap() const;

private:
  struct Node
  {
    std::array<float, 3> Low, High;            // mm, a little too large
    std::array<float, 3> MinNormal, MaxNormal; // of unit normals, a little too large
    Index MinFragment, MaxFragment;
  };
  class Boxes;

  Index FirstOf(std::size_t leaf) const;
  void FillLeaf(std::size_t leaf);
  void Join(std::size_t node);
  Index FragmentOf(Index triangle) const;
  TriangleCorners CornersOf(Index triangle) const;
  static double SquaredDistance(const Node& node, const Vector3& p);
  static double SquaredDistance(const Node& a, const Node& b);
  static bool MayFace(
    const Node& node, double squaredDistance, const Vector3& p, const Vector3& normal);
  template <typename Wants, typename Visit>
  void Walk(
    const Vector3& p, const double& squaredLimit, const Wants& wants, const Visit& visit) const;
  double MinBetween(std::size_t leafA, std::size_t leafB, double squaredLimit) const;

  const Surface& Source;
  const Components& Fragments;
  std::size_t Leaves;      // a power of two
  std::vector<Node> Nodes; // children of i: 2 i and 2 i + 1; the root is 1
};
}

#endif
