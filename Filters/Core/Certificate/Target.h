// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Target.h
 * @brief The set to which distances are certified. What is called the value of a point is its distance to one simplex less
 *        that simplex's tolerance; the value to the set is the least of them, mm.
 *
 * The tree only finds candidates. Values of candidates bound the value to the set from above whichever they are; the one
 * bound from below, for the place of the maximum, looks at every simplex and needs no tree.
 */
#ifndef BoneDecimate_Core_Certificate_Target_h
#define BoneDecimate_Core_Certificate_Target_h

#include "Foot.h"
#include "Geometry/BoundingTree.h"
#include "Simplices.h"

#include <functional>
#include <vector>

namespace bonedecimate::certificate
{
class Target
{
public:
  /// Keeps a reference to the simplices, of which there must be one.
  Target(const Simplices& simplices, int threads, const std::function<void()>& afterStep);

  /// mm, of each simplex, from now on.
  void SetTolerances(std::vector<double> tolerances);

  struct Candidate
  {
    Index Simplex = None;
    double Value = 0.0; ///< mm
  };
  /// The simplex of the least value, as far as the tree knows.
  Candidate FindLeast(const Vector3& p, Index hint) const;

  /// Value to this simplex, mm: never below the true one but for rounding.
  double ValueTo(const Vector3& p, Index simplex) const
  {
    return FindFoot(p, this->CornersOf(simplex)).Distance - this->Tolerance(simplex);
  }

  /// A lower bound of the value to the set, mm, but for rounding.
  double ValueFromBelow(const Vector3& p, double startValue) const;

  /// A simplex that has all these places among its corners; None if none was found.
  Index FindSame(const Corners& places, int count) const;

  bool HasTolerances() const { return !this->Tolerances.empty(); }
  double Tolerance(Index simplex) const
  {
    return this->Tolerances.empty() ? 0.0 : this->Tolerances[simplex];
  }

  const certificate::Simplices& All() const { return this->Set; }
  Corners CornersOf(Index simplex) const;
  bool HasCorner(Index simplex, const Vector3& place) const
  {
    const Corners corners = this->CornersOf(simplex);
    return corners[0] == place || corners[1] == place || corners[2] == place;
  }

private:
  const Simplices& Set;
  BoundingTree Tree;
  std::vector<double> Tolerances; // mm; empty: 0
  double LargestTolerance = 0.0;  // mm
};
}

#endif
