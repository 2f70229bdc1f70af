// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NewCrossings.h
 * @brief Triangles that intersect or are turned over after their points have moved, and were not before.
 *
 *     pairs:   triangles whose boxes overlap, from a binary tree of boxes over the triangles as they come, which lie along a
 *              curve that fills space; pairs that intersect (Intersections/TrianglePair.h) and did not before
 *     turned:  triangles whose normal has turned by 90 degrees or more, or that have lost their area
 *
 * The result does not depend on the number of threads.
 */
#ifndef BoneDecimate_Core_Smoothing_NewCrossings_h
#define BoneDecimate_Core_Smoothing_NewCrossings_h

#include "Intersections/TrianglePair.h"
#include "Monitor.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate
{
class NewCrossings
{
public:
  /// @param before Must outlive this.
  NewCrossings(const Surface& before, int threads);

  /**
   * @param points Where the points of the surface are now, mm.
   * @param isMoved Of each triangle: pairs of two triangles without it are left out.
   * @param monitor May be empty; after an abort the list is not complete.
   * @return The triangles, ascending.
   */
  std::vector<Index> Find(
    const std::vector<Vector3>& points, const std::vector<char>& isMoved, const Monitor& monitor);

private:
  struct Box
  {
    Vector3 Low, High; // mm
    bool Overlaps(const Box& other) const
    {
      return (other.High - this->Low).minCoeff() >= 0.0 &&
        (this->High - other.Low).minCoeff() >= 0.0;
    }
  };
  Box BoxOf(const std::vector<Vector3>& points, std::size_t triangle) const;
  void FillTree(const std::vector<Vector3>& points);
  void FindNear(const Box& box, std::vector<std::size_t>& leaves) const;
  void FindOfLeaf(std::size_t leaf, const std::vector<Vector3>& points,
    const std::vector<char>& isMoved, std::vector<Index>& found) const;
  bool IsTurnedOver(const std::vector<Vector3>& points, const Triangle& corners) const;
  /// Two triangles where they are now.
  struct Pair
  {
    const PlaneTriangle& First;
    const PlaneTriangle& Second;
  };
  bool IsNew(const Pair& now, std::size_t a, std::size_t b) const;

  const Surface& Before;
  int Threads;
  std::size_t Leaves;     // a power of two
  std::vector<Box> Boxes; // children of i: 2 i and 2 i + 1; the root is 1
};
}

#endif
