// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Attack.cxx
 * @brief bonedecimate-attack: searches for a violation of the largest error, or for a voxel that changes its label.
 *
 *     bonedecimate-attack RUNS SEED [SURFACE.ply ...]
 *     bonedecimate-attack --labels RUNS SEED             surfaces of label maps (LabelAttack.h)
 *     bonedecimate-attack --near RUNS SEED             parts that are near to each other (NearAttack.h)
 *
 * Every run is a random surface, or a piece cut out of one of the files, with random options, sometimes with a random map of
 * tolerances, sometimes so far from the origin that rounding matters. The certificate, which is independent of the run,
 * then checks the error. Ends with 1 at the first violation and prints its seed: RUNS 1 with that SEED repeats it.
 */
#include "AttackChecks.h"
#include "LabelAttack.h"
#include "NearAttack.h"
#include "Shapes.h"
#include "TriangleFile.h"
#include "Victims.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr long RunsBetweenWords = 1000; // some minutes

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
  options.AllowLargeError = true;
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
  if (random.Below(4) == 0)
  {
    options.Smoothing = options.MaximumError * std::pow(10.0, random.Between(-1.5, 0.3));
    options.FeatureAngle = random.Between(0.0, 180.0);
  }
  attack.IsRounded =
    options.OutputPointsPrecision == PointsPrecision::Single && random.Below(2) == 0;
  if (attack.IsRounded)
  {
    RoundToSingle(attack.Victim);
  }
  if (random.Below(4) == 0)
  {
    options.MinimumAngle = random.Between(0.0, 40.0);
  }
  options.EdgeLength = DrawEdgeLength(random, attack.Victim);
  return attack;
}

/// Whether writing moves points that the guard does not check again.
bool IsMovedByWriting(const Attack& attack)
{
  return attack.Requested.OutputPointsPrecision == PointsPrecision::Single && !attack.IsRounded;
}

/// Empty if there is no violation.
std::string WhatBroke(const Attack& attack, Totals& totals)
{
  const Result result = Decimate(attack.Victim, attack.Requested, {},
    { false, false, attack.Tolerances.empty() ? nullptr : &attack.Tolerances });
  const std::optional<CleanSurface> cleaned = CountRun(attack.Victim, result, totals);
  if (!cleaned)
  {
    return {};
  }
  const std::string lost = WhatTopologyLost(cleaned->Surface, result.Surface);
  const std::string read = WhatTopologyLost(cleaned->Surface, AsRead(result.Surface));
  std::string broke = !lost.empty() ? lost : read;
  broke =
    broke.empty() ? WhatBoundBroke(attack, *cleaned, result.Surface, totals) : std::move(broke);
  if (broke.empty() && !IsMovedByWriting(attack))
  {
    broke = WhatPierces(attack, cleaned->Surface, result.Surface);
    const bool isSmoothed = attack.Requested.Smoothing > 0.0; // that moves all points at once
    broke = broke.empty() && !isSmoothed ? WhatJumped(cleaned->Surface, result.Surface)
                                         : std::move(broke);
  }
  return broke;
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

/// Empty if there is no violation.
std::string AttackOnce(std::uint64_t seed, const std::vector<Surface>& large, Totals& totals)
{
  const Attack attack = AnyAttack(seed, large);
  const std::string broke = WhatBroke(attack, totals);
  return broke.empty() ? broke : broke + " (" + Described(attack) + ")";
}

void Print(const Totals& totals)
{
  std::printf("%lld runs, %lld of them rejected; %lld triangles became %lld; at most "
              "%.4f of the error was used; no violation\n",
    static_cast<long long>(totals.Runs), static_cast<long long>(totals.Rejected),
    static_cast<long long>(totals.TrianglesIn), static_cast<long long>(totals.TrianglesOut),
    totals.MaxRatio);
  if (totals.Guarded > 0)
  {
    std::printf("%lld runs were smoothed, in %lld voxels were guarded, %lld results were counted "
                "exactly; %lld voxels changed in runs without the guard\n",
      static_cast<long long>(totals.Smoothed), static_cast<long long>(totals.Guarded),
      static_cast<long long>(totals.ExactlyCounted), static_cast<long long>(totals.ChangedVoxels));
  }
  if (totals.ComponentPairs > 0)
  {
    std::printf(
      "%lld pairs of rings, %lld of them linked, %lld pairs of components, %lld of plates: "
      "nothing has passed through anything\n",
      static_cast<long long>(totals.RingPairs), static_cast<long long>(totals.LinkedPairs),
      static_cast<long long>(totals.ComponentPairs), static_cast<long long>(totals.Views));
  }
}

/// @param attack Returns what broke in the run of a seed.
int Run(
  long runs, std::uint64_t seed, const std::function<std::string(std::uint64_t, Totals&)>& attack)
{
  Totals totals;
  for (long run = 0; run < runs; ++run)
  {
    const std::uint64_t at = seed + static_cast<std::uint64_t>(run);
    const std::string broke = attack(at, totals);
    if (!broke.empty())
    {
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(at), broke.c_str());
      return EXIT_FAILURE;
    }
    if ((run + 1) % RunsBetweenWords == 0)
    {
      std::fprintf(stderr, "%ld runs\n", run + 1);
    }
  }
  Print(totals);
  return EXIT_SUCCESS;
}
}

int main(int argumentCount, char** words)
{
  const std::string kind = argumentCount > 1 ? words[1] : "";
  const bool hasKind = kind == "--labels" || kind == "--near";
  const int first = hasKind ? 2 : 1;
  if (argumentCount < first + 2 || (hasKind && argumentCount > first + 2))
  {
    std::fputs("usage: bonedecimate-attack RUNS SEED [SURFACE.ply ...]\n"
               "       bonedecimate-attack --labels RUNS SEED\n"
               "       bonedecimate-attack --near RUNS SEED\n",
      stderr);
    return EXIT_FAILURE;
  }
  try
  {
    const long runs = std::atol(words[first]);
    const std::uint64_t seed = std::strtoull(words[first + 1], nullptr, 10);
    const std::vector<Surface> large = ReadAll(argumentCount - first - 2, words + first + 2);
    if (hasKind)
    {
      return Run(runs, seed, kind == "--labels" ? AttackLabels : AttackNear);
    }
    return Run(runs, seed,
      [&large](std::uint64_t at, Totals& totals) { return AttackOnce(at, large, totals); });
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-attack: %s\n", failure.what());
    return EXIT_FAILURE;
  }
}
