// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AttackChecks.h"

#include "BruteForce.h"
#include "Crossings.h"
#include "Mesh/SurfaceAssembly.h"
#include "Proof/Certificate/Certificate.h"
#include "VoxelOracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

namespace bonedecimate::testsupport
{
namespace
{
std::string WhatItSays(const Certificate& found)
{
  char text[450];
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

constexpr std::size_t MostOfPairs = 3000;  // triangles of which all pairs are tested
constexpr std::size_t MostComponents = 12; // of which all pairs are tested

/// Steradians, seen from a point (A. van Oosterom, J. Strackee, The solid angle of a plane triangle, 1983).
double SolidAngle(const Vector3& from, const Surface& surface, const Triangle& t)
{
  const Vector3 a = surface.Points[static_cast<std::size_t>(t[0])] - from;
  const Vector3 b = surface.Points[static_cast<std::size_t>(t[1])] - from;
  const Vector3 c = surface.Points[static_cast<std::size_t>(t[2])] - from;
  const double x = a.norm();
  const double y = b.norm();
  const double z = c.norm();
  return 2.0 *
    std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
}

/// Pairs of closed components of which one lies in the other, where they do not intersect; -1 if there are too many.
int CountNested(const Surface& surface)
{
  std::vector<Surface> closed;
  for (Surface& part : SplitComponents(surface))
  {
    if (CountTopology(part).BoundaryEdges == 0)
    {
      closed.push_back(std::move(part));
    }
  }
  int count = closed.size() > MostComponents ? -1 : 0;
  for (std::size_t i = 0; count >= 0 && i < closed.size(); ++i)
  {
    const Index point = closed[i].Triangles[0][0];
    for (std::size_t j = 0; j < closed.size(); ++j)
    {
      const Vector3& p = closed[i].Points[static_cast<std::size_t>(point)];
      count += i != j && std::abs(WindingNumber(closed[j], p)) > 0.5 ? 1 : 0;
    }
  }
  return count;
}
}

double WindingNumber(const Surface& closed, const Vector3& p)
{
  double angle = 0.0;
  for (const Triangle& t : closed.Triangles)
  {
    angle += SolidAngle(p, closed, t);
  }
  return angle / (4.0 * 3.14159265358979323846);
}

//------------------------------------------------------------------------------
std::optional<CleanSurface> CountRun(const Surface& victim, const Result& result, Totals& totals)
{
  ++totals.Runs;
  if (result.Report.Status != InputStatus::Good)
  {
    ++totals.Rejected;
    return std::nullopt;
  }
  CleanSurface cleaned = Cleaned(victim);
  totals.TrianglesIn += static_cast<std::int64_t>(cleaned.Surface.Triangles.size());
  totals.TrianglesOut += static_cast<std::int64_t>(result.Surface.Triangles.size());
  return cleaned;
}

//------------------------------------------------------------------------------
CleanSurface Cleaned(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  for (std::size_t p = 0; p < clean.Surface.Points.size(); ++p)
  {
    clean.Surface.Points[p] = input.Points[clean.InputPoint[p]]; // bit for bit
  }
  return clean;
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
std::string WhatTopologyLost(const Surface& before, const Surface& after)
{
  const Topology was = CountTopology(before);
  const Topology is = CountTopology(after);
  return was.Components != is.Components                  ? "lost a component"
    : was.EulerNumber != is.EulerNumber                   ? "lost the Euler number"
    : (was.BoundaryEdges == 0) != (is.BoundaryEdges == 0) ? "lost the boundaries"
    : is.NonManifoldEdges > was.NonManifoldEdges          ? "lost an edge that was manifold"
    : is.NonManifoldPoints > was.NonManifoldPoints        ? "lost a point that was manifold"
                                                          : "";
}

//------------------------------------------------------------------------------
void RoundToSingle(Surface& surface)
{
  for (Vector3& p : surface.Points)
  {
    p = RoundedToSingle(p); // gcc 12 leaves coordinates as they are that are cast there and back
  }
}

//------------------------------------------------------------------------------
std::string WhatPierces(const Attack& attack, const Surface& before, const Surface& after)
{
  if (before.Triangles.size() > MostOfPairs)
  {
    return {};
  }
  const std::int64_t pairs = CountIntersections(after);
  const std::int64_t pairsBefore = pairs == 0 ? 0
    : attack.IsRounded                        ? CountIntersections(before)
                                              : CountCrossings(before);
  return pairs > pairsBefore ? std::to_string(pairs) + " pairs of triangles pierce each other, " +
      std::to_string(pairsBefore) + " before"
                             : std::string();
}

//------------------------------------------------------------------------------
std::string WhatJumped(const Surface& before, const Surface& after)
{
  const bool isClear = before.Triangles.size() <= MostOfPairs && CountCrossings(before) == 0 &&
    CountCrossings(after) == 0;
  return isClear && CountNested(before) != CountNested(after)
    ? "a component went through another one"
    : std::string();
}

//------------------------------------------------------------------------------
std::string WhatBoundBroke(
  const Attack& attack, const CleanSurface& cleaned, const Surface& result, Totals& totals)
{
  const double error = attack.Requested.MaximumError;
  CertificateOptions options;
  if (error > 0.0)
  {
    options.Tolerance = error;
  }
  options.ToleranceMap = CleanedMap(cleaned, attack.Tolerances);
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(cleaned.Surface, result, options);
  totals.MaxRatio =
    error > 0.0 ? std::max(totals.MaxRatio, found.Upper() / error) : totals.MaxRatio;
  return found.Proof == ProofStatus::Proved ? std::string() : WhatItSays(found);
}

//------------------------------------------------------------------------------
std::string Described(const Attack& attack)
{
  const Options& options = attack.Requested;
  char text[400];
  std::snprintf(text, sizeof(text),
    "mode %d, error %.17g mm, smoothing %.17g mm%s, feature angle %.17g, least angle %.17g, "
    "edge length %.17g mm, target "
    "%d, threads %d, %s "
    "precision, %s map, "
    "%zu triangles",
    static_cast<int>(options.Mode), options.MaximumError, options.Smoothing,
    options.AutomaticSmoothing ? " or automatic" : "", options.FeatureAngle, options.MinimumAngle,
    options.EdgeLength, options.TargetNumberOfTriangles, options.NumberOfThreads,
    options.OutputPointsPrecision == PointsPrecision::Single ? "single" : "double",
    attack.Tolerances.empty() ? "no" : "a", attack.Victim.Triangles.size());
  return text;
}
}
