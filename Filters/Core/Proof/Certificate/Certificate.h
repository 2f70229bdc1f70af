// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Certificate.h
 * @brief Proved bounds of the two-sided Hausdorff distance of two surfaces and of their boundaries,
 * compared with a tolerance. Reads two surfaces and nothing else.
 *
 *     reference, result    exact local frame, nothing merged, nothing dropped
 *     boundaries           edges of one triangle, after merging points of equal coordinates
 *     bounds               of both directions, for surfaces and boundaries: Search.h
 *     statistics           means and distances of points
 *
 * The first bounds are known at once and get tighter. After an abort those proved until then are
 * returned.
 *
 * Every bound is widened by its largest rounding error (Foot.h), so it holds for the surfaces as
 * they are stored. Documentation/explanation/certificate.md gives the proof step by step.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Certificate_h
#define BoneDecimate_Core_Proof_Certificate_Certificate_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace bonedecimate
{
/// Whether two surfaces can be compared.
enum class CertificateStatus : int
{
  Good = 0,
  EmptyReference, ///< No triangle.
  EmptyResult,
  /// A triangle has a point index out of range, or a point that is not finite or beyond 1e30 mm.
  BadReference,
  BadResult,
  /// The number of entries of the map is not that of the points of the reference, or a tolerance is
  /// infinite or negative.
  BadTolerance,
  Aborted ///< By the monitor: the bounds are those proved so far, and other figures are missing.
};

enum class ProofStatus : int
{
  NotRequested = 0, ///< There is no tolerance.
  Proved,           ///< The distance of every point is within its tolerance.
  Violated,         ///< The distance of at least one point exceeds its tolerance.
  Undecided,        ///< Neither was shown within MaxCuts or the limits of rounding.
  Aborted           ///< The run was aborted before its proof.
};

/// The largest distance from one set to another, mm, or the largest excess of distance over
/// tolerance.
struct DistanceBounds
{
  double Lower = -std::numeric_limits<double>::infinity();
  double Upper = std::numeric_limits<double>::infinity();
  Vector3 Position = Vector3::Zero(); ///< mm, where the distance is at least Lower.
  /// The one that contains Position. None: the set is empty, or no point of it has a limit.
  Index Triangle = None;
  Index NearestTriangle = None; ///< The nearest one of the other surface.
  std::int64_t Cuts = 0;        ///< Number of cuts of pieces.
};

/// Mean and root mean square of the distance over the area of one surface, mm. Errors are two
/// standard errors; see MeanDistance.h.
struct MeanDistance
{
  double Mean = 0.0;
  double MeanError = 0.0;
  double RootMeanSquare = 0.0;
  double RootMeanSquareError = 0.0;
  double Area = 0.0; ///< mm^2
  std::int64_t Samples = 0;
};

/// Distance of each point of one surface to the other, and the side on which it lies
/// (SideFinder.h).
struct SignedDistances
{
  std::vector<double> Distance;  ///< mm; not a number for points beyond 1e30 mm or not finite
  std::vector<signed char> Side; ///< 1: outside; -1: inside; 0: on the surface, or unknown
};

/// The bounds of one direction.
struct DirectedCertificate
{
  DistanceBounds Distance;
  MeanDistance Mean;      ///< with WithMeans, and only of surfaces
  SignedDistances Points; ///< with WithPointDistances, and only of surfaces
  /// mm, of each triangle: an upper bound of the distance of its points. Only of surfaces, and with
  /// a triangle gap.
  std::vector<double> TriangleUpper;
  DistanceBounds Excess; ///< of the distance over the tolerance map, if there is one
  ProofStatus Proof = ProofStatus::NotRequested;
};

enum class BoundaryPresence : int
{
  Neither = 0,   ///< Both surfaces are closed: nothing is measured and any tolerance is met.
  ReferenceOnly, ///< The distance is infinite: any tolerance is violated.
  ResultOnly,
  Both
};

/// Called with proved bounds of the two-sided distance of the surfaces, mm.
using BoundsListener = std::function<void(double lower, double upper)>;

struct CertificateOptions
{
  /// mm; not negative. Holds for every point, in both directions.
  std::optional<double> Tolerance;
  /**
   * mm, at each point of the reference, linear on its triangles; may be empty. Negative or NaN: no
   * limit but Tolerance, which also caps all others. From the result to the reference, the
   * tolerance of a reference triangle is the least of its corners, and each point of the result has
   * to be within the tolerance of one triangle. A triangle without a limit accepts all points.
   */
  std::vector<double> ToleranceMap;
  /// Refine the bounds to the gap even if the tolerance is already proved; always so without a
  /// tolerance.
  bool TightBounds = true;
  /// The search ends when the bounds differ by at most this fraction of the upper one, by MinGap,
  /// or by 1e-9 of the largest coordinate, or after MaxCuts.
  double RelativeGap = 1e-6;
  double MinGap = 0.0; ///< mm
  /// Largest number of cuts in each direction; 0: 2^26 and sixteen for each triangle.
  std::int64_t MaxCuts = 0;
  bool WithSurfaces = true;
  bool OneSided = false; ///< From the reference to the result alone; the other direction is empty.
  bool WithBoundaries = true;
  bool WithMeans = false;          ///< Also compute mean and root mean square.
  double MeanPrecision = 1e-3;     ///< Relative; reached unless it takes more than 2^21 samples.
  bool WithPointDistances = false; ///< Also compute distance and side of each point.
  /// mm; above 0: also compute an upper bound for each triangle. It exceeds the largest distance of
  /// the triangle by at most this gap, unless its search ends after 4,096 cuts.
  double ReferenceTriangleGap = 0.0;
  double ResultTriangleGap = 0.0;
  int NumberOfThreads = 0; ///< 0: one per processor; the result does not depend on it
  /// Called on the calling thread, before the monitor, with bounds that hold at that moment and are
  /// tighter than those of the call before; may be empty. The result does not depend on it.
  BoundsListener OnBounds;
};

struct Certificate
{
  CertificateStatus Status = CertificateStatus::Good;
  ProofStatus Proof = ProofStatus::NotRequested; ///< of all directions together
  DirectedCertificate ReferenceToResult;
  DirectedCertificate ResultToReference;
  bool BoundariesCompared = false; ///< with WithBoundaries
  BoundaryPresence Boundaries = BoundaryPresence::Neither;
  /// Curve to curve. All bounds are 0 if neither surface has boundaries, and infinite if only one
  /// has.
  DirectedCertificate BoundaryOfReferenceToResult;
  DirectedCertificate BoundaryOfResultToReference;
  double Slack = 0.0; ///< mm, by which all bounds are widened for rounding.
  double Seconds = 0.0;

  /// mm, bounds of the two-sided distance of the surfaces, boundaries not included.
  double Lower() const;
  double Upper() const;
};

/**
 * @param reference The surface to which a tolerance map belongs. Any triangles are allowed: without
 *   area, not manifold, with repeated points. Points that no triangle uses are ignored.
 * @throws std::bad_alloc and nothing else.
 */
Certificate Certify(const Surface& reference, const Surface& result,
  const CertificateOptions& options = {}, const Monitor& monitor = {});

/// The status as in reports: "proved".
const char* ProofStatusWord(ProofStatus status);
/// A sentence about the problem; empty if Good.
const char* StatusSentence(CertificateStatus status);
}

#endif
