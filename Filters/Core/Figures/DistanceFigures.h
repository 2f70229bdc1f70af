// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceFigures.h
 * @brief Measured and proved distances between two surfaces.
 */
#ifndef BoneDecimate_Core_Figures_DistanceFigures_h
#define BoneDecimate_Core_Figures_DistanceFigures_h

#include <array>
#include <cstdint>

namespace bonedecimate
{
enum class ProofStatus : int; // of Proof/Certificate/Certificate.h
enum class BoundaryPresence : int;

/// Distances of one surface to another, mm.
struct DistanceStatistics
{
  /// Over all points and all area samples: a lower bound of the true maximum.
  double Maximum = 0.0;
  std::array<double, 3> MaximumAt{}; ///< mm, the point or sample at which it was found.
  double Second = 0.0; ///< Second largest over the points alone, as in the tables of the thesis.
  double Mean = 0.0;   ///< Over the area samples.
  double RootMeanSquare = 0.0; ///< Over the area samples.
  double PointMaximum = 0.0;   ///< Over the points alone.
  double PointMean = 0.0;
  double PointRootMeanSquare = 0.0;
  std::int64_t Samples = 0;
  double SamplesPerSquareMillimeter = 0.0;
};

/// Proved bounds of the largest distance from one surface or boundary to the other, mm.
struct ProvedDistance
{
  double Lower = 0.0;
  double Upper = 0.0;
};

/// The certificate of the result as it is written.
struct ErrorProof
{
  bool WasMade = false;   ///< If false, all other members but an aborted status are meaningless.
  ProofStatus Status{};   ///< For everything that was compared.
  double Tolerance = 0.0; ///< mm, the error to prove for all points; 0: none.
  ProvedDistance InputToOutput;
  ProvedDistance OutputToInput;
  /// Boundaries after merging points of equal coordinates; not compared without MergePoints.
  bool BoundariesCompared = false;
  /// If only one surface has boundaries, their distance is infinite.
  BoundaryPresence Boundaries{};
  ProvedDistance BoundaryInputToOutput;
  ProvedDistance BoundaryOutputToInput;

  double Lower() const; ///< mm, the largest over both directions, boundaries included.
  double Upper() const;
};

/// Least distance between two fragments, mm.
struct FragmentGap
{
  double Input = 0.0;
  double Output = 0.0;
};
}

#endif
