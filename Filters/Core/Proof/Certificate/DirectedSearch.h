// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DirectedSearch.h
 * @brief The bounds of the distance of one set to another, from the first ones on.
 *
 *     FindFirstBounds    at once: the box of the source and one point of the target
 *     BuildTarget        from here on the parts of the source, one point of each
 *     FindValues         from here on its whole simplices
 *     FindDistance       within the gap, or as far as it gets
 *
 * What is proved after any of these steps, and at any moment of the last one, is in Bounds() if
 * there is a listener, and in Found() after an abort.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_DirectedSearch_h
#define BoneDecimate_Core_Proof_Certificate_DirectedSearch_h

#include "PairCertificate.h"
#include "Search.h"
#include "Target.h"

#include <functional>
#include <optional>
#include <vector>

namespace bonedecimate::certificate
{
class DirectedSearch
{
public:
  /// Keeps references to the sets, which must not be empty.
  /// @param triangleGap mm, of the bounds of single triangles; 0: they are not computed.
  /// @param tell Called on the calling thread when bounds may have got tighter; may be empty.
  DirectedSearch(const Simplices& source, const Simplices& target, const PairTask& task,
    double triangleGap, std::function<void()> tell);

  /// Builds the tree. May run on another thread than all else, which needs the tree.
  void BuildTarget(const std::function<void()>& afterStep);
  /// Narrows the bounds by what the tree tells.
  void TakeParts();
  void FindValues(Stages& progress, double weight);
  void FindDistance(Stages& progress, double weight);
  /// @param limit mm, at each point of the source; finite for one at least.
  void FindExcessOverPoints(const std::vector<double>& limit, Stages& progress, double weight);
  /// @param limits mm, of each simplex of the target; all finite.
  void FindExcessOverSimplices(std::vector<double> limits, Stages& progress, double weight);
  /// Means and distances of points.
  void AddStatistics(Stages& progress, double weight);
  /// The bounds of the excess if there is no limit.
  void MarkUnlimited();

  /// mm, what is proved so far.
  const DistanceBounds& Bounds() const { return this->Known; }
  /// Everything found, with the ids of triangles.
  /// @param wasStopped The bounds are those proved so far.
  DirectedCertificate Found(bool wasStopped);

private:
  SearchGoal FirstGoal(std::size_t simplices) const;
  double UpperOfParts() const;
  void Conclude();
  ProofStatus ProofSoFar(ProofStatus found) const;
  void Narrow(double upper, const MaxExcess& max);
  void Tell();
  SearchListener Listener();
  double SufficientValue() const;
  PointValues Values(Stages& progress, double weight, double sufficient) const;
  DistanceBounds Find(const KnownBounds& known, const Monitor& monitor);
  void Decide(double tolerance, Stages& progress);
  KnownBounds BoundTriangles(const Monitor& monitor) const;
  void FindExcess(const Simplices& source, double largest, Stages& progress, double weight);

  const Simplices& Source;
  const Simplices& TargetSet;
  const PairTask& Task;
  double TriangleGap; // mm
  SearchGoal Goal;
  std::function<void()> TellOuter;
  std::optional<Target> To;
  PointValues PointDistances;
  bool HasValues = false;
  bool HasExcess = false;
  DirectedCertificate Output;
  DistanceBounds Known;       // proved so far
  double LargestFound = -1.0; // mm, the distance from which the lower bound of Known follows
};
}

#endif
