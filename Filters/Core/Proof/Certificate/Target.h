// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Target.h
 * @brief The set to which distances are certified. The value of a point to a simplex is its
 * distance minus the tolerance of the simplex, mm; its value to the set is the least of these.
 *
 * The tree only finds candidates. The value to any candidate is an upper bound of the value to the
 * set. The lower bound at the maximum is computed from all simplices, without the tree.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Target_h
#define BoneDecimate_Core_Proof_Certificate_Target_h

#include "Base/WorkspacePool.h"
#include "EdgeSides.h"
#include "Foot.h"
#include "Geometry/BoundingTree.h"
#include "OverlayCover.h"
#include "Simplices.h"

#include <functional>
#include <vector>

namespace bonedecimate::certificate
{
class Target
{
public:
  /// Keeps a reference to the simplices, which must not be empty.
  Target(const Simplices& simplices, int threads, const std::function<void()>& afterStep);

  /// Sets the tolerance of each simplex, mm; empty: 0.
  void SetTolerances(std::vector<double> tolerances);

  /// Lends a cover to one worker. Null if the simplices are no surface or have tolerances: a cover
  /// knows only distances.
  std::shared_ptr<OverlayCover> BorrowCover() const;

  struct Candidate
  {
    Index Simplex = None;
    double Value = 0.0; ///< mm
  };
  /// The simplex of least value among the candidates of the tree.
  Candidate FindLeast(const Vector3& p, Index hint) const;
  /// Any simplex with a value up to sufficient (mm) if there is one, otherwise FindLeast().
  Candidate FindNear(const Vector3& p, Index hint, double sufficient) const;

  /// Value to this simplex, mm: an upper bound, up to rounding.
  double ValueTo(const Vector3& p, Index simplex) const
  {
    return FindFoot(p, this->CornersOf(simplex)).Distance - this->Tolerance(simplex);
  }

  /// Lower bound of the value to the set, mm, up to rounding.
  double ValueFromBelow(const Vector3& p, double startValue) const;

  /// A simplex whose corners include all these positions; None if the tree finds none.
  Index FindSame(const Corners& positions, int count) const;

  bool HasTolerances() const { return !this->Tolerances.empty(); }
  double Tolerance(Index simplex) const
  {
    return this->Tolerances.empty() ? 0.0 : this->Tolerances[simplex];
  }

  /// The neighbors across the sides of a triangle of a surface.
  const std::array<Index, 3>& Neighbors(Index triangle) const
  {
    return (*this->Set.Sides)[triangle];
  }

  const certificate::Simplices& All() const { return this->Set; }
  Corners CornersOf(Index simplex) const;
  bool HasCorner(Index simplex, const Vector3& position) const
  {
    const Corners corners = this->CornersOf(simplex);
    return corners[0] == position || corners[1] == position || corners[2] == position;
  }

private:
  const Simplices& Set;
  BoundingTree Tree;
  std::vector<double> Tolerances; // mm; empty: 0
  double MaxTolerance = 0.0;      // mm
  mutable WorkspacePool<OverlayCover> Covers;
};
}

#endif
