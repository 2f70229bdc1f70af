// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearAttack.h"

#include "BruteForce.h"
#include "Crossings.h"
#include "NearVictims.h"
#include "Victims.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double MostOff = 0.01; // of a linking or winding number from an integer

/// A surface with its components in the order of those of the input.
struct Parts
{
  bonedecimate::Surface Whole;
  std::vector<Surface> Components; // each has all points
};

/// @param outputPoint For each point of the input, the point of the surface; empty: the same.
Parts PartsOf(const Surface& surface, const std::vector<Surface>& components,
  const std::vector<Index>& outputPoint)
{
  Parts parts = { surface, SplitComponents(surface) };
  const auto isOf = [&](const Surface& part, const Surface& input)
  {
    const Index point = outputPoint[input.Triangles[0][0]];
    return std::any_of(part.Triangles.begin(), part.Triangles.end(),
      [&](const Triangle& t) { return std::find(t.begin(), t.end(), point) != t.end(); });
  };
  std::vector<Surface> ordered;
  for (const Surface& input : components)
  {
    const auto found = std::find_if(parts.Components.begin(), parts.Components.end(),
      [&](const Surface& part) { return isOf(part, input); });
    if (found != parts.Components.end())
    {
      ordered.push_back(*found);
    }
  }
  parts.Components = std::move(ordered);
  return parts;
}

/// The loop of a ring; empty if nothing runs around its axis.
Loop LoopOf(const NearVictim& victim, std::size_t ring, const Surface& surface)
{
  std::vector<Axis> axes = { victim.Rings[ring].Hole };
  for (std::size_t other = 0; victim.AreHandles && other < victim.Rings.size(); ++other)
  {
    if (other != ring)
    {
      axes.push_back(victim.Rings[other].Hole);
    }
  }
  const Index nearest = BruteNearest(surface, victim.Rings[ring].Start).Triangle;
  return LoopAround(surface, surface.Triangles[nearest][0], axes);
}

struct Link
{
  bool IsKnown = false;
  long Number = 0;
};

Link LinkOf(const Loop& a, const Loop& b)
{
  const double number = LinkingNumber(a, b);
  const double rounded = std::round(number);
  return { !a.empty() && !b.empty() && std::abs(number - rounded) < MostOff,
    static_cast<long>(rounded) };
}

std::string WhatLinked(
  const NearVictim& victim, const Surface& before, const Surface& after, Totals& totals)
{
  std::vector<Loop> loopsBefore;
  std::vector<Loop> loopsAfter;
  for (std::size_t ring = 0; ring < victim.Rings.size(); ++ring)
  {
    loopsBefore.push_back(LoopOf(victim, ring, before));
    loopsAfter.push_back(LoopOf(victim, ring, after));
  }
  for (std::size_t i = 0; i < victim.Rings.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Link was = LinkOf(loopsBefore[i], loopsBefore[j]);
      const Link is = LinkOf(loopsAfter[i], loopsAfter[j]);
      if (victim.AreHandles && (!was.IsKnown || !is.IsKnown))
      {
        continue; // both loops run through the bridge
      }
      if (!was.IsKnown || !is.IsKnown)
      {
        return "the linking number of two rings is not known";
      }
      ++totals.RingPairs;
      totals.LinkedPairs += was.Number != 0 ? 1 : 0;
      if (was.Number != is.Number)
      {
        return "the linking number of two rings was " + std::to_string(was.Number) + " and is " +
          std::to_string(is.Number);
      }
    }
  }
  return {};
}

/// How often a closed component winds around a point, in whole turns; 0 for open ones.
long Winding(const Surface& component, const Vector3& p)
{
  return CountTopology(component).BoundaryEdges > 0 ? 0 : std::lround(WindingNumber(component, p));
}

std::string WhatChangedSides(const Parts& before, const Parts& after, Totals& totals)
{
  for (std::size_t i = 0; i < before.Components.size(); ++i)
  {
    const Surface& was = before.Components[i];
    const Surface& is = after.Components[i];
    const bool isClosed = CountTopology(was).BoundaryEdges == 0;
    if (isClosed && (SignedVolume(was) > 0.0) != (SignedVolume(is) > 0.0))
    {
      return "a component was turned inside out";
    }
    for (std::size_t j = 0; j < before.Components.size(); ++j)
    {
      if (i == j)
      {
        continue;
      }
      ++totals.ComponentPairs;
      const Vector3& from = was.Points[was.Triangles[0][0]];
      const Vector3& to = is.Points[is.Triangles[0][0]];
      if (Winding(before.Components[j], from) != Winding(after.Components[j], to))
      {
        return "a component went into another one or came out of it";
      }
    }
  }
  return {};
}

/// The points of a component in the middle of the plates.
std::vector<Vector3> PointsInTheMiddle(const NearVictim& victim, const Surface& component)
{
  std::vector<Vector3> points;
  for (const Triangle& t : component.Triangles)
  {
    for (const Index corner : t)
    {
      const Vector3& p = component.Points[corner];
      if ((p - victim.Middle.Point).cross(victim.Middle.Direction).norm() < victim.Radius)
      {
        points.push_back(p);
      }
    }
  }
  return points;
}

/// Whether all rays of a view meet the other component.
bool Sees(const NearVictim& victim, const NearVictim::View& view, const Parts& parts)
{
  const std::vector<Vector3> points = PointsInTheMiddle(victim, parts.Components[view.From]);
  return std::all_of(points.begin(), points.end(),
    [&](const Vector3& p) { return RayMeets(p, view.Direction, parts.Components[view.To]); });
}

std::string WhatChangedOrder(
  const NearVictim& victim, const Parts& before, const Parts& after, Totals& totals)
{
  for (const NearVictim::View& view : victim.Views)
  {
    const bool isClear = Sees(victim, view, before); // noise can be too much
    totals.Views += isClear ? 1 : 0;
    if (isClear && !Sees(victim, view, after))
    {
      return "a plate or a speck has passed a plate";
    }
  }
  return {};
}

Attack AnyAttack(Random& random, NearVictim& victim)
{
  Attack attack;
  Options& options = attack.Requested;
  options.Mode = static_cast<Mode>(1 + random.Below(3));
  options.MeasureDistances = false;
  options.MaximumError = victim.Error;
  options.AllowLargeError = true;
  options.NumberOfThreads = random.Below(8) == 0 ? 2 + random.Below(2) : 1;
  attack.IsRounded = random.Below(4) == 0;
  options.OutputPointsPrecision =
    attack.IsRounded ? PointsPrecision::Single : PointsPrecision::Double;
  if (random.Below(4) == 0)
  {
    attack.Tolerances = AnyMap(random, victim.Surface, victim.Error);
    options.OutputPointsPrecision = PointsPrecision::Double; // a tolerance of 0 allows no rounding
  }
  if (attack.IsRounded)
  {
    RoundToSingle(victim.Surface);
  }
  if (random.Below(6) == 0)
  {
    options.TargetNumberOfTriangles =
      1 + random.Below(static_cast<Index>(victim.Surface.Triangles.size()));
  }
  if (random.Below(6) == 0)
  {
    options.Smoothing = options.MaximumError * std::pow(10.0, random.Between(-2.0, -0.3));
  }
  if (random.Below(6) == 0)
  {
    options.MinimumAngle = random.Between(0.0, 30.0);
  }
  options.EdgeLength = random.Below(2) == 0 ? 0.0 : DrawEdgeLength(random, victim.Surface);
  attack.Victim = victim.Surface;
  return attack;
}

/// The points that edits start from: smoothing moves all at once, and looks for new pairs that
/// intersect alone.
Surface BeforeEdits(const Attack& attack, const RunInputs& inputs)
{
  Surface surface = attack.Victim;
  if (attack.Requested.Smoothing > 0.0)
  {
    surface.Points = SmoothOnly(surface, attack.Requested, {}, inputs).Points;
  }
  return surface;
}

std::string WhatPassed(const NearVictim& victim, const Attack& attack, const RunInputs& inputs,
  const Result& result, Totals& totals)
{
  const Surface start = BeforeEdits(attack, inputs);
  std::string broke = WhatPierces(attack, start, result.Surface);
  if (!broke.empty() || CountCrossings(start) > 0)
  {
    return broke;
  }
  std::vector<Index> same(start.Points.size());
  std::iota(same.begin(), same.end(), 0);
  const std::vector<Surface> components = SplitComponents(start);
  const Parts before = PartsOf(start, components, same);
  const Parts after = PartsOf(result.Surface, components, result.Origins.OutputPoint);
  if (after.Components.size() != before.Components.size())
  {
    return "a component is not there any more";
  }
  broke = WhatLinked(victim, start, result.Surface, totals);
  broke = broke.empty() ? WhatChangedSides(before, after, totals) : broke;
  return broke.empty() ? WhatChangedOrder(victim, before, after, totals) : broke;
}
}

std::string AttackNear(std::uint64_t seed, Totals& totals)
{
  Random random(seed);
  NearVictim victim = AnyNearVictim(random);
  const Attack attack = AnyAttack(random, victim);
  RunInputs inputs;
  inputs.WantsOrigins = true;
  inputs.Tolerances = attack.Tolerances.empty() ? nullptr : &attack.Tolerances;
  const Result result = Decimate(attack.Victim, attack.Requested, {}, inputs);
  const std::optional<CleanSurface> cleaned = CountRun(attack.Victim, result, totals);
  if (!cleaned)
  {
    return {};
  }
  std::string broke = WhatTopologyLost(cleaned->Surface, result.Surface);
  broke = broke.empty() ? WhatPassed(victim, attack, inputs, result, totals) : broke;
  broke = broke.empty() ? WhatBoundBroke(attack, *cleaned, result.Surface, totals) : broke;
  return broke.empty() ? broke : broke + " (" + Described(attack) + ")";
}
}
