// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Attack.cxx
 * @brief bonedecimate-attack: tries to break the promise of a largest error.
 *
 *     bonedecimate-attack RUNS SEED [SURFACE.ply ...]
 *
 * Every run is a random surface, or a piece cut out of one of the files, with random options, at times a random map of
 * tolerances, at times so far from the origin that rounding counts, simplified and then judged by the certificate, which
 * knows nothing of how it was made. Ends with 1 at the first run that broke the promise, and names its seed: RUNS 1 with
 * that SEED does it again.
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
  std::int64_t Refused = 0; // no surface, or an error that the precision asked for cannot hold
  std::int64_t TrianglesIn = 0;
  std::int64_t TrianglesOut = 0;
  double LargestShare = 0.0; // of the error allowed
};

struct Attack
{
  Surface Victim;
  Options Asked;
  std::vector<double> Tolerances; // mm, of each point; empty: no map
};

/// Nothing may change in one ball, nothing is limited in another, in between the tolerance grows with the distance.
std::vector<double> AnyMap(Random& random, const Surface& surface, double error)
{
  const auto anyPoint = [&]
  {
    return surface
      .Points[static_cast<std::size_t>(random.Below(static_cast<Index>(surface.Points.size())))];
  };
  const Vector3 frozen = anyPoint();
  const Vector3 free = anyPoint();
  const double radius = MeanEdge(surface) * random.Between(0.0, 6.0);
  const double slope = random.Between(0.0, 0.5);
  std::vector<double> tolerances;
  for (const Vector3& p : surface.Points)
  {
    const double distance = std::max(0.0, (p - frozen).norm() - radius);
    tolerances.push_back(
      (p - free).norm() < radius ? -1.0 : std::min(2.0 * error, slope * distance));
  }
  return tolerances;
}

/// So far from the origin that single precision moves points by some share of an edge, and an error of the same order:
/// points that never move are moved when they are written.
void PutWhereRoundingCounts(Random& random, Attack& attack)
{
  const double distance = MeanEdge(attack.Victim) * std::pow(10.0, random.Between(4.0, 6.5));
  attack.Victim =
    Moved(attack.Victim, { distance, distance * random.Uniform(), distance * random.Uniform() });
  const double unit = distance * std::numeric_limits<float>::epsilon();
  attack.Asked.MaximumError = unit * std::pow(10.0, random.Between(0.0, 1.5));
}

Attack AnyAttack(std::uint64_t seed, const std::vector<Surface>& large)
{
  Random random(seed);
  Attack attack;
  attack.Victim = AnyVictim(random, large);
  Options& options = attack.Asked;
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
    options.OutputPointsPrecision =
      PointsPrecision::Double; // a tolerance of 0 leaves no room for rounding
  }
  if (options.OutputPointsPrecision == PointsPrecision::Single && random.Below(3) == 0)
  {
    PutWhereRoundingCounts(random, attack);
  }
  return attack;
}

/// What decimation takes for the input: equal points are one, triangles without area are not there.
CleanSurface Cleaned(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  for (std::size_t p = 0; p < clean.Surface.Points.size(); ++p)
  {
    clean.Surface.Points[p] = input.Points[clean.InputPoint[p]]; // bit for bit
  }
  return clean;
}

/// With points of equal coordinates as one.
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

/// The least of the points that are one now; -1 where none has a limit.
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

/// Empty if the topology is what it was.
const char* WhatTopologyLost(const Surface& before, const Surface& after)
{
  const Topology was = CountTopology(before);
  const Topology is = CountTopology(after);
  return was.Components != is.Components                  ? "a component"
    : was.EulerNumber != is.EulerNumber                   ? "the Euler number"
    : (was.BoundaryEdges == 0) != (is.BoundaryEdges == 0) ? "the borders"
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
    "borders %s and %s",
    VerdictWord(found.Verdict), there.Distance.Upper, back.Distance.Upper, there.Excess.Lower,
    there.Excess.Upper, back.Excess.Lower, back.Excess.Upper,
    VerdictWord(found.BorderOfReferenceToResult.Verdict),
    VerdictWord(found.BorderOfResultToReference.Verdict));
  return text;
}

/// Empty if everything was kept.
std::string WhatBroke(const Attack& attack, Totals& totals)
{
  const Result result = Decimate(attack.Victim, attack.Asked, {},
    { false, false, attack.Tolerances.empty() ? nullptr : &attack.Tolerances });
  ++totals.Runs;
  if (result.Report.Status != InputStatus::Good)
  {
    ++totals.Refused;
    return {};
  }
  const CleanSurface cleaned = Cleaned(attack.Victim);
  totals.TrianglesIn += static_cast<std::int64_t>(cleaned.Surface.Triangles.size());
  totals.TrianglesOut += static_cast<std::int64_t>(result.Surface.Triangles.size());
  std::string lost = WhatTopologyLost(cleaned.Surface, result.Surface);
  lost = lost.empty() ? WhatTopologyLost(cleaned.Surface, AsRead(result.Surface)) : lost;
  CertificateOptions options;
  options.Tolerance = attack.Asked.MaximumError;
  options.ToleranceMap = CleanedMap(cleaned, attack.Tolerances);
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(cleaned.Surface, result.Surface, options);
  totals.LargestShare = std::max(totals.LargestShare, found.Upper() / attack.Asked.MaximumError);
  return !lost.empty()                            ? "lost " + lost
    : found.Verdict == CertificateVerdict::Proved ? std::string()
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
    static_cast<unsigned long long>(seed), broke.c_str(), static_cast<int>(attack.Asked.Mode),
    attack.Asked.MaximumError, attack.Asked.TargetNumberOfTriangles, attack.Asked.NumberOfThreads,
    attack.Tolerances.empty() ? "no" : "a", attack.Victim.Triangles.size());
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
  std::printf("%lld runs, %lld of them refused; %lld triangles became %lld; at most "
              "%.4f of the error "
              "was used; none broke the promise\n",
    static_cast<long long>(totals.Runs), static_cast<long long>(totals.Refused),
    static_cast<long long>(totals.TrianglesIn), static_cast<long long>(totals.TrianglesOut),
    totals.LargestShare);
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
