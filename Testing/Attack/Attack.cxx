// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Attack.cxx
 * @brief bonedecimate-attack: searches for a violation of the largest error.
 *
 *     bonedecimate-attack RUNS SEED [SURFACE.ply ...]
 *
 * Every run is a random surface, or a piece cut out of one of the files, with random options, sometimes with a random map of
 * tolerances, sometimes so far from the origin that rounding matters. The certificate, which is independent of the run,
 * then checks the error. Ends with 1 at the first violation and prints its seed: RUNS 1 with that SEED repeats it.
 */
#include "BruteForce.h"
#include "Certificate/Certificate.h"
#include "Decimate.h"
#include "Mesh/Cleaning.h"
#include "Shapes.h"
#include "TriangleFile.h"
#include "Victims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr long RunsBetweenWords = 1000; // some minutes

struct Totals
{
  std::int64_t Runs = 0;
  std::int64_t Rejected = 0; // no surface, or an error below the requested precision
  std::int64_t TrianglesIn = 0;
  std::int64_t TrianglesOut = 0;
  double LargestRatio = 0.0; // of the distance to the allowed error
};

struct Attack
{
  Surface Victim;
  Options Requested;
  std::vector<double> Tolerances; // mm, of each point; empty: no map
};

/// The tolerance is 0 in one ball, there is none in another, and it grows with the distance in between.
std::vector<double> AnyMap(Random& random, const Surface& surface, double error)
{
  const auto anyPoint = [&]
  {
    return surface
      .Points[static_cast<std::size_t>(random.Below(static_cast<Index>(surface.Points.size())))];
  };
  const Vector3 center = anyPoint();
  const Vector3 free = anyPoint();
  const double radius = MeanEdge(surface) * random.Between(0.0, 6.0);
  const double slope = random.Between(0.0, 0.5);
  std::vector<double> tolerances;
  for (const Vector3& p : surface.Points)
  {
    const double distance = std::max(0.0, (p - center).norm() - radius);
    tolerances.push_back(
      (p - free).norm() < radius ? -1.0 : std::min(2.0 * error, slope * distance));
  }
  return tolerances;
}

/// So far from the origin that single precision moves points by a fraction of an edge, and an error of the same order:
/// points that never move are moved when they are written.
void PutWhereRoundingCounts(Random& random, Attack& attack)
{
  const double distance = MeanEdge(attack.Victim) * std::pow(10.0, random.Between(4.0, 6.5));
  attack.Victim =
    Moved(attack.Victim, { distance, distance * random.Uniform(), distance * random.Uniform() });
  const double unit = distance * std::numeric_limits<float>::epsilon();
  attack.Requested.MaximumError = unit * std::pow(10.0, random.Between(0.0, 1.5));
}

Attack AnyAttack(std::uint64_t seed, const std::vector<Surface>& large)
{
  Random random(seed);
  Attack attack;
  attack.Victim = AnyVictim(random, large);
  Options& options = attack.Requested;
  options.Mode = static_cast<Mode>(1 + random.Below(3));
  options.MeasureDistances = false;
  options.MaximumError = MeanEdge(attack.Victim) * std::pow(10.0, random.Between(-2.0, 1.0));
  options.NumberOfThreads = 1 + random.Below(3);
  options.OutputPointsPrecision =
    random.Below(2) == 0 ? PointsPrecision::Single : PointsPrecision::Double;
  if (random.Below(4) == 0)
  {
    options.TargetNumberOfTriangles =
      1 + random.Below(static_cast<Index>(attack.Victim.Triangles.size()) + 1);
  }
  if (random.Below(3) == 0)
  {
    attack.Tolerances = AnyMap(random, attack.Victim, options.MaximumError);
    options.OutputPointsPrecision = PointsPrecision::Double; // a tolerance of 0 allows no rounding
  }
  if (options.OutputPointsPrecision == PointsPrecision::Single && random.Below(3) == 0)
  {
    PutWhereRoundingCounts(random, attack);
  }
  return attack;
}

/// The input of the decimation after cleaning: equal points merged, triangles without area dropped.
CleanSurface Cleaned(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  for (std::size_t p = 0; p < clean.Surface.Points.size(); ++p)
  {
    clean.Surface.Points[p] = input.Points[clean.InputPoint[p]]; // bit for bit
  }
  return clean;
}

/// Merges points of equal coordinates.
Surface AsRead(Surface surface)
{
  std::map<std::array<double, 3>, Index> first;
  for (Triangle& corners : surface.Triangles)
  {
    for (Index& corner : corners)
    {
      const Vector3& p = surface.Points[static_cast<std::size_t>(corner)];
      corner = first.emplace(std::array<double, 3>{ p[0], p[1], p[2] }, corner).first->second;
    }
  }
  return surface;
}

/// The least tolerance of the merged points; -1 if none has a limit.
std::vector<double> CleanedMap(const CleanSurface& clean, const std::vector<double>& tolerances)
{
  std::vector<double> map(tolerances.empty() ? 0 : clean.Surface.Points.size(), -1.0);
  for (std::size_t p = 0; p < tolerances.size(); ++p)
  {
    const Index point = clean.PointOfInput[p];
    if (point != None && tolerances[p] >= 0.0)
    {
      double& least = map[static_cast<std::size_t>(point)];
      least = least < 0.0 ? tolerances[p] : std::min(least, tolerances[p]);
    }
  }
  return map;
}

/// Empty if the topology is unchanged.
const char* WhatTopologyLost(const Surface& before, const Surface& after)
{
  const Topology was = CountTopology(before);
  const Topology is = CountTopology(after);
  return was.Components != is.Components                  ? "a component"
    : was.EulerNumber != is.EulerNumber                   ? "the Euler number"
    : (was.BoundaryEdges == 0) != (is.BoundaryEdges == 0) ? "the boundaries"
    : is.NonManifoldEdges > was.NonManifoldEdges          ? "an edge that was manifold"
    : is.NonManifoldPoints > was.NonManifoldPoints        ? "a point that was manifold"
                                                          : "";
}

std::string WhatItSays(const Certificate& found)
{
  char text[400];
  const DirectedCertificate& there = found.ReferenceToResult;
  const DirectedCertificate& back = found.ResultToReference;
  std::snprintf(text, sizeof(text),
    "the certificate says %s: %.17g and %.17g mm, over the map %.3g to %.3g and %.3g to %.3g mm, "
    "boundaries %s and %s",
    ProofStatusWord(found.Proof), there.Distance.Upper, back.Distance.Upper, there.Excess.Lower,
    there.Excess.Upper, back.Excess.Lower, back.Excess.Upper,
    ProofStatusWord(found.BoundaryOfReferenceToResult.Proof),
    ProofStatusWord(found.BoundaryOfResultToReference.Proof));
  return text;
}

/// Empty if there is no violation.
std::string WhatBroke(const Attack& attack, Totals& totals)
{
  const Result result = Decimate(attack.Victim, attack.Requested, {},
    { false, false, attack.Tolerances.empty() ? nullptr : &attack.Tolerances });
  ++totals.Runs;
  if (result.Report.Status != InputStatus::Good)
  {
    ++totals.Rejected;
    return {};
  }
  const CleanSurface cleaned = Cleaned(attack.Victim);
  totals.TrianglesIn += static_cast<std::int64_t>(cleaned.Surface.Triangles.size());
  totals.TrianglesOut += static_cast<std::int64_t>(result.Surface.Triangles.size());
  std::string lost = WhatTopologyLost(cleaned.Surface, result.Surface);
  lost = lost.empty() ? WhatTopologyLost(cleaned.Surface, AsRead(result.Surface)) : lost;
  CertificateOptions options;
  options.Tolerance = attack.Requested.MaximumError;
  options.ToleranceMap = CleanedMap(cleaned, attack.Tolerances);
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(cleaned.Surface, result.Surface, options);
  totals.LargestRatio =
    std::max(totals.LargestRatio, found.Upper() / attack.Requested.MaximumError);
  return !lost.empty()                   ? "lost " + lost
    : found.Proof == ProofStatus::Proved ? std::string()
                                         : WhatItSays(found);
}

std::vector<Surface> ReadAll(int count, char** paths)
{
  std::vector<Surface> surfaces;
  for (int i = 0; i < count; ++i)
  {
    const Triangles read = ReadPly(paths[i]);
    Surface surface;
    for (const auto& [x, y, z] : read.Points)
    {
      surface.Points.emplace_back(x, y, z);
    }
    surface.Triangles.assign(read.Corners.begin(), read.Corners.end());
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

void PrintFailure(std::uint64_t seed, const Attack& attack, const std::string& broke)
{
  std::printf(
    "seed %llu: %s (mode %d, error %.17g mm, target %d, threads %d, %s map, %zu triangles)\n",
    static_cast<unsigned long long>(seed), broke.c_str(), static_cast<int>(attack.Requested.Mode),
    attack.Requested.MaximumError, attack.Requested.TargetNumberOfTriangles,
    attack.Requested.NumberOfThreads, attack.Tolerances.empty() ? "no" : "a",
    attack.Victim.Triangles.size());
}

int Run(long runs, std::uint64_t seed, const std::vector<Surface>& large)
{
  Totals totals;
  for (long run = 0; run < runs; ++run)
  {
    const Attack attack = AnyAttack(seed + static_cast<std::uint64_t>(run), large);
    const std::string broke = WhatBroke(attack, totals);
    if (!broke.empty())
    {
      PrintFailure(seed + static_cast<std::uint64_t>(run), attack, broke);
      return EXIT_FAILURE;
    }
    if ((run + 1) % RunsBetweenWords == 0)
    {
      std::fprintf(stderr, "%ld runs\n", run + 1);
    }
  }
  std::printf("%lld runs, %lld of them rejected; %lld triangles became %lld; at most "
              "%.4f of the error "
              "was used; no violation\n",
    static_cast<long long>(totals.Runs), static_cast<long long>(totals.Rejected),
    static_cast<long long>(totals.TrianglesIn), static_cast<long long>(totals.TrianglesOut),
    totals.LargestRatio);
  return EXIT_SUCCESS;
}
}

int main(int argumentCount, char** words)
{
  if (argumentCount < 3)
  {
    std::fputs("usage: bonedecimate-attack RUNS SEED [SURFACE.ply ...]\n", stderr);
    return EXIT_FAILURE;
  }
  try
  {
    return Run(std::atol(words[1]), std::strtoull(words[2], nullptr, 10),
      ReadAll(argumentCount - 3, words + 3));
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-attack: %s\n", failure.what());
    return EXIT_FAILURE;
  }
}
