// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AttackChecks.h
 * @brief What an attack runs, and whether the result keeps to the error bound and to the topology of the input.
 */
#ifndef BoneDecimate_Testing_AttackChecks_h
#define BoneDecimate_Testing_AttackChecks_h

#include "Mesh/Cleaning.h"
#include "Run/Decimate.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
struct Attack
{
  Surface Victim;
  Options Requested;
  std::vector<double> Tolerances; // mm, of each point; empty: no map
  bool IsRounded =
    false; // coordinates are those of single precision, so that writing moves no point
};

struct Totals
{
  std::int64_t Runs = 0;
  std::int64_t Rejected = 0; // no surface, or an error below the requested precision
  std::int64_t TrianglesIn = 0;
  std::int64_t TrianglesOut = 0;
  double MaxRatio = 0.0; // of the distance to the allowed error
  // Counts of runs on label maps:
  std::int64_t Smoothed = 0;
  std::int64_t Guarded = 0;
  std::int64_t ChangedVoxels = 0; // in runs without the guard
  std::int64_t ExactlyCounted = 0;
  // Counts of runs on near parts:
  std::int64_t RingPairs = 0;
  std::int64_t LinkedPairs = 0;
  std::int64_t ComponentPairs = 0;
  std::int64_t Views = 0;
};

/// Counts a run. Returns its input after cleaning; none if it was rejected.
std::optional<CleanSurface> CountRun(const Surface& victim, const Result& result, Totals& totals);

/// The input of the decimation after cleaning: equal points merged, triangles without area dropped.
CleanSurface Cleaned(const Surface& input);

/// Merges points of equal coordinates.
Surface AsRead(Surface surface);

/// The least tolerance of the merged points; -1 if none has a limit.
std::vector<double> CleanedMap(const CleanSurface& clean, const std::vector<double>& tolerances);

/// Empty if the topology is unchanged.
std::string WhatTopologyLost(const Surface& before, const Surface& after);

/// Coordinates in single precision.
void RoundToSingle(Surface& surface);

/// Empty if no more pairs of triangles pierce each other. Where writing moves points, pairs that only touched may do so.
std::string WhatPierces(const Attack& attack, const Surface& before, const Surface& after);

/// How often a closed surface winds around a point, by solid angles.
double WindingNumber(const Surface& closed, const Vector3& p);

/// Empty if no closed component went into another one or came out of it. Surfaces that intersect are not tested.
std::string WhatJumped(const Surface& before, const Surface& after);

/// Empty if the certificate proves the result within the error and the map, relative to the input.
std::string WhatBoundBroke(
  const Attack& attack, const CleanSurface& cleaned, const Surface& result, Totals& totals);

std::string Described(const Attack& attack);
}

#endif
