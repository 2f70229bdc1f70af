// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NewCrossings.h
 * @brief Triangles that intersect or are turned over after their points have moved, and were not
 * before.
 *
 *     pairs:   triangles whose boxes overlap, from a binary tree of boxes over the triangles in
 *              their order, which is that of a space-filling curve; pairs that intersect
 *              (Proof/Guard/TrianglePair.h) and did not before, or that pierce each other and
 *              only touched before
 *     passed:  on request, pairs without a common corner that pass through each other on the
 *              way (Motion.h)
 *     turned:  triangles whose normal has turned by 90 degrees or more, or that have lost
 *              their area
 *
 * The result does not depend on the number of threads.
 */
#ifndef BoneDecimate_Core_Smoothing_NewCrossings_h
#define BoneDecimate_Core_Smoothing_NewCrossings_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"
#include "Proof/Guard/TrianglePair.h"

#include <vector>

namespace bonedecimate
{
class NewCrossings
{
public:
  /// Times at which triangles are compared.
  enum class Times
  {
    End, ///< Where the points are now.
    All  ///< Also pairs that pass through each other.
  };
  /// @param before Must outlive this.
  NewCrossings(const Surface& before, Times times, int threads);

  /**
   * @param points Moved points of the surface, mm.
   * @param isMoved For each triangle. Pairs of two triangles that have not moved are left out.
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
      return other.High[0] >= this->Low[0] && this->High[0] >= other.Low[0] &&
        other.High[1] >= this->Low[1] && this->High[1] >= other.Low[1] &&
        other.High[2] >= this->Low[2] && this->High[2] >= other.Low[2];
    }
  };
  struct Query
  {
    const std::vector<Vector3>& Points;
    const std::vector<char>& IsMoved;
    bool AreAllMoved; ///< Then each pair is found only from its first leaf.
  };
  void FillTree(const std::vector<Vector3>& points);
  void FindNear(std::size_t leaf, bool withEarlier, std::vector<std::size_t>& leaves) const;
  void FindBelow(std::size_t node, const Box& box, std::vector<std::size_t>& leaves) const;
  void FindOfLeaf(std::size_t leaf, const Query& query, std::vector<Index>& found) const;
  struct Leaf;
  void FindOfTriangle(
    std::size_t triangle, const Leaf& leaf, const Query& query, std::vector<Index>& found) const;
  bool IsTurnedOver(const std::vector<Vector3>& points, const Triangle& corners) const;
  /// Two triangles at their moved positions.
  struct Pair
  {
    const PlaneTriangle& First;
    const PlaneTriangle& Second;
  };
  bool IsNew(const Pair& now, std::size_t a, std::size_t b) const;

  const Surface& SurfaceBefore;
  Times CheckedTimes;
  int Threads;
  std::size_t Leaves;     // a power of two
  std::vector<Box> Boxes; // children of i: 2 i and 2 i + 1; the root is 1
  std::vector<Box> TriangleBoxes;
};
}

#endif
