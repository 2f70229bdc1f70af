// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundedSolver.h
 * @brief Bounded regularized least squares: displacements of the points of a surface that minimize
 *
 *     sum |d_i|^2 + lambda |L (x0 + d)|^2    subject to d_i in the set of point i
 *                                            (DisplacementSets.h)
 *
 * by projected gradients with constant momentum:
 *
 *     d' = P(y - (y + lambda L^T (L (x0 + y))) / (1 + lambda D))
 *     y' = d' + beta (d' - d)
 *     D_i   twice the absolute sum of column i of L
 *     beta  (sqrt k - 1) / (sqrt k + 1), k = 1 + 4 lambda
 *
 * D bounds the largest eigenvalue of L^T L scaled by it, so every step is safe. After ceil(4 sqrt
 * k) iterations the error is a few micrometers; after half as many if they start near the minimum.
 * Double precision; the result does not depend on the number of threads.
 *
 * Y. Nesterov, Introductory Lectures on Convex Optimization, 2004, 2.2: constant step, strongly
 * convex.
 */
#ifndef BoneDecimate_Core_Smoothing_BoundedSolver_h
#define BoneDecimate_Core_Smoothing_BoundedSolver_h

#include "Base/Monitor.h"
#include "DisplacementSets.h"
#include "SmoothingGraph.h"

#include <vector>

namespace bonedecimate
{
class BoundedSolver
{
public:
  /// @param points mm. All references must outlive this.
  BoundedSolver(const SmoothingGraph& graph, const DisplacementSets& sets,
    const std::vector<Vector3>& points, int threads);

  /// Reads the graph again after its rows have changed.
  /// @param points mm, as in the constructor.
  void ReadRows(const std::vector<Vector3>& points);

  /// Number of iterations after which displacements are accurate to a few micrometers.
  /// @param isNear Whether they start at the result of a few iterations with a similar lambda.
  int IterationsOf(double lambda, bool isNear) const;

  /// Moves the displacements, in units of the sets, from their present values towards the minimum.
  /// @param monitor May be empty.
  /// @return False after an abort; the displacements are then still within the sets.
  bool Run(
    double lambda, int iterations, const Monitor& monitor, std::vector<Vector3>& displacements);

  /// The same for some points; all others keep their displacement.
  /// @param points Ascending.
  void RunSome(
    double lambda, const std::vector<Index>& points, std::vector<Vector3>& displacements);

private:
  /// The strength along each axis: longer units are smoothed more, because their quantization is
  /// coarser.
  Vector3 Strengths(double lambda) const;
  void FillRow(Index point);
  void Step(
    Index point, const Vector3& strengths, double momentum, std::vector<Vector3>& displacements);

  const SmoothingGraph& Graph;
  const DisplacementSets& Sets;
  int Threads;
  std::vector<Vector3> InitialRows;  // L x0, in units of the sets
  std::vector<Vector3> Extrapolated; // y
  std::vector<Vector3> Rows;         // L (x0 + y)
  std::vector<double> ColumnBounds;  // D
};
}

#endif
