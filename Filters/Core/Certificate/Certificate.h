// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Certificate.h
 * @brief How far two surfaces are from each other, proved: bounds of the two-sided Hausdorff distance, of the
 *        distance of their borders, and of both against a tolerance. Reads two surfaces and nothing else.
 *
 *     reference, result    exact local frame, nothing merged, nothing dropped
 *     borders              edges of one triangle, where points of equal coordinates are one point
 *     both directions of surface and border:  Search.h
 *
 * Every bound is widened by what rounding can do to it (Foot.h): they hold for the surfaces as they are stored.
 * Documentation/certificate.md has the proof step by step.
 */
#ifndef BoneDecimate_Core_Certificate_Certificate_h
#define BoneDecimate_Core_Certificate_Certificate_h

#include "Monitor.h"
#include "Surface.h"

#include <cstdint>
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
  BadReference, ///< A triangle names a point that is not there, or one that is not finite or beyond 1e30 mm.
  BadResult,
  BadTolerance, ///< A map that has not one entry for each point of the reference, or an infinite or negative tolerance.
  Aborted       ///< The monitor asked for it.
};

enum class CertificateVerdict : int
{
  NotAsked = 0, ///< No tolerance was given.
  Proved,       ///< No point is farther than its tolerance allows.
  Violated,     ///< The place of the maximum is farther.
  Undecided     ///< Neither, within the work allowed or the limits of rounding.
};

/// The largest distance from one set to another, mm, or the largest excess of distance over tolerance.
struct DistanceBounds
{
  double Lower = -std::numeric_limits<double>::infinity();
  double Upper = std::numeric_limits<double>::infinity();
  Vector3 Place = Vector3::Zero(); ///< mm, where the distance is at least Lower
  Index Triangle =
    None; ///< on which the place is; None: the set is empty, or nothing in it is limited
  Index NearestTriangle = None; ///< of the other surface
  std::int64_t Cuts = 0;        ///< how often a piece was cut
};

/// Of the distance over the area of one surface, mm. Errors are two standard errors; see MeanDistance.h.
struct MeanDistance
{
  double Mean = 0.0;
  double MeanError = 0.0;
  double RootMeanSquare = 0.0;
  double RootMeanSquareError = 0.0;
  double Area = 0.0; ///< mm^2
  std::int64_t Samples = 0;
};

/// The distance of each point of one surface to the other, and on which side it is; see SideFinder.h.
struct SignedDistances
{
  std::vector<double> Distance;  ///< mm; not a number for points beyond 1e30 mm or not finite
  std::vector<signed char> Side; ///< 1: outside; -1: inside; 0: on it, or not to be told
};

/// The bounds of one direction.
struct DirectedCertificate
{
  DistanceBounds Distance;
  MeanDistance Mean;      ///< only if asked for, and not of borders
  SignedDistances Points; ///< only if asked for, and not of borders
  /// mm, for each triangle no less than the distance of any of its points; only if asked for, and not of borders.
  std::vector<double> TriangleUpper;
  DistanceBounds Excess; ///< over the tolerance map; only with one
  CertificateVerdict Verdict = CertificateVerdict::NotAsked;
};

enum class BorderPresence : int
{
  Neither = 0,   ///< Both are closed: nothing is measured, any tolerance is kept.
  ReferenceOnly, ///< Infinitely far: any tolerance is violated.
  ResultOnly,
  Both
};

struct CertificateOptions
{
  /// mm; not negative. Of every point, in both directions.
  std::optional<double> Tolerance;
  /**
   * mm, at each point of the reference, linear on its triangles; none if empty. Negative or not a number: no limit of its
   * own but Tolerance, which caps the others, too. From the result to the reference, each triangle of the reference
   * counts with the least tolerance of its corners, and each point of the result needs one triangle that explains
   * it; a triangle without any limit explains all.
   */
  std::vector<double> ToleranceMap;
  /// Refine up to the gap even where the tolerance is already proved. Without a tolerance that is always so.
  bool TightBounds = true;
  /// The bounds differ by at most this share of the upper one, by the least gap, or by a thousand-millionth of the largest
  /// coordinate, unless MostCuts ends it before.
  double RelativeGap = 1e-6;
  double LeastGap = 0.0; ///< mm; bounds that are nearer to each other are not sought.
  /// How often pieces may be cut in each direction; 0: sixteen times for each triangle, and 2^26 times.
  std::int64_t MostCuts = 0;
  bool WithSurfaces = true;
  bool WithBorders = true;
  bool WithMeans = false;      ///< Average and root mean square, too.
  double MeanPrecision = 1e-3; ///< Share of them to which they are estimated, if 2^21 samples do.
  bool WithPointDistances = false; ///< Distance and side of each point, too.
  /// mm; above 0: an upper bound for each triangle, too, by at most so much above its largest distance, unless 4,096 cuts
  /// of the triangle end it before.
  double ReferenceTriangleGap = 0.0;
  double ResultTriangleGap = 0.0;
  int NumberOfThreads = 0; ///< 0: one per processor; the answer is the same
};

struct Certificate
{
  CertificateStatus Status = CertificateStatus::Good;
  CertificateVerdict Verdict = CertificateVerdict::NotAsked; ///< of all directions together
  DirectedCertificate ReferenceToResult;
  DirectedCertificate ResultToReference;
  BorderPresence Borders = BorderPresence::Neither;
  /// Curve to curve. All bounds are 0 without borders, and infinite if only one of the surfaces has some.
  DirectedCertificate BorderOfReferenceToResult;
  DirectedCertificate BorderOfResultToReference;
  double Slack = 0.0; ///< mm, by which bounds are widened for rounding; inside of them
  double Seconds = 0.0;

  double Lower() const; ///< mm, of the two-sided distance of the surfaces without their borders
  double Upper() const;
};

/**
 * @param reference The first surface, which a tolerance map belongs to. Any triangles: without area, not manifold, with
 *        repeated points. Points that no triangle uses do not count.
 * @throws std::bad_alloc and nothing else.
 */
Certificate Certify(const Surface& reference, const Surface& result,
  const CertificateOptions& options = {}, const Monitor& monitor = {});

/// One word: "proved".
const char* VerdictWord(CertificateVerdict verdict);
/// What is wrong, for people; empty if nothing is.
const char* StatusSentence(CertificateStatus status);
}

#endif
