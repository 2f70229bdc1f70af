// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearVictims.h"

#include "BruteForce.h"
#include "Crossings.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr Index MaxAround = 70;            // points of a loop
constexpr std::size_t MaxTriangles = 3000; // of which all pairs are tested

using Ring = NearVictim::Ring;

Vector3 AnyDirection(Random& random)
{
  const double z = random.Between(-1.0, 1.0);
  const double angle = random.Between(0.0, 2.0 * Pi);
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

Loop Circle(const Vector3& center, const Vector3& x, const Vector3& y, double radius, double edge)
{
  const Index count = std::clamp<Index>(static_cast<Index>(2.0 * Pi * radius / edge), 8, MaxAround);
  Loop loop;
  for (Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.01) / count;
    loop.emplace_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return loop;
}

/// A square in the plane z = 0 from (-half, 0) to (half, 2 half), whose first side dips below it in the middle.
Loop DippingSquare(Random& random, double half, double depth, double width)
{
  const Index cells = 3 + random.Below(22); // of a side
  const Index dipCells = random.Below(3) == 0 ? 1 + random.Below(6) : 1;
  const double step = 2.0 * half / cells;
  Loop loop;
  for (Index i = 0; i < cells && -half + i * step < -width - 0.1 * step; ++i)
  {
    loop.emplace_back(-half + i * step, 0.0, 0.0);
  }
  const auto before = static_cast<std::ptrdiff_t>(loop.size());
  for (Index i = -dipCells; i <= dipCells; ++i)
  {
    const double t = static_cast<double>(i) / dipCells;
    loop.emplace_back(t * width, 0.0, -depth * (1.0 - std::abs(t)));
  }
  for (std::ptrdiff_t i = before - 1; i > 0; --i)
  {
    loop.emplace_back(-loop[static_cast<std::size_t>(i)][0], 0.0, 0.0);
  }
  const std::array<Vector3, 4> corners = { Vector3(half, 0.0, 0.0), Vector3(half, 2.0 * half, 0.0),
    Vector3(-half, 2.0 * half, 0.0), Vector3(-half, 0.0, 0.0) };
  for (std::size_t side = 0; side < 3; ++side)
  {
    for (Index i = 0; i < cells; ++i)
    {
      loop.emplace_back(corners[side] + (corners[side + 1] - corners[side]) * i / cells);
    }
  }
  return loop;
}

/**
 * A square loop dips to the other side of the lowest or the highest part of an upright ring: if it was straight, the two would be linked
 * or not, and they are not or are.
 */
NearVictim DippingRings(Random& random)
{
  NearVictim victim;
  const double error = 0.5 * std::pow(10.0, random.Between(-0.3, 0.3));
  const double thickness = error * random.Between(0.04, 0.12); // radius of the tubes
  const double depth = error * random.Between(0.4, 0.95);
  const double half = error * random.Between(5.0, 12.0);
  const double radius = error * random.Between(1.8, 4.0); // of the upright ring
  const double height = -depth * random.Between(0.35, 0.65);
  const double sign = random.Below(2) == 0 ? 1.0 : -1.0; // whether the ring stands or hangs
  const Vector3 center(0.0, 0.0, height + sign * radius);
  Loop square = DippingSquare(random, half, depth, error * random.Between(0.6, 3.0));
  Loop circle = Circle(center, Vector3(0.0, -1.0, 0.0), Vector3(0.0, 0.0, 1.0), radius,
    error * random.Between(0.1, 0.6));
  const double noise = random.Below(2) == 0 ? 0.0 : thickness * random.Between(0.0, 0.7);
  for (Loop* loop : { &square, &circle })
  {
    std::for_each(loop->begin(), loop->end(), [&](Vector3& p) { p += random.InCube(noise); });
  }
  const double flatness = random.Below(3) == 0 ? random.Between(2.0, 8.0) : 1.0;
  const Surface first = Tube(square, thickness, 3 + random.Below(5), flatness);
  const Surface second = Tube(circle, thickness, 3 + random.Below(5), flatness);
  victim.AreHandles = random.Below(3) == 0;
  const bool isNear = random.Below(2) == 0; // whether the bridge is where the two are near
  const double turn = random.Between(-1.2, 1.2);
  const Vector3 nearby = center - sign * radius * Vector3(0.0, std::sin(turn), std::cos(turn));
  const Vector3 along(error * random.Between(-1.5, 1.5), 0.0, -depth);
  victim.Surface = !victim.AreHandles ? Together(first, second)
    : isNear ? Bridged(second, first, nearby, along, error * random.Between(0.05, 0.5))
             : Bridged(second, first, center + (radius + thickness) * Vector3::UnitY(),
                 { 0.0, 2.0 * half, sign * thickness }, half);
  victim.Rings = { { { { 0.0, half, 0.0 }, Vector3::UnitZ() }, { -half, 2.0 * half, 0.0 } },
    { { center, Vector3::UnitX() }, center - radius * Vector3::UnitY() } };
  victim.Error = error;
  return victim;
}

/// Ring whose start is farthest from the points of the others; false if it is too near to them.
bool FindStart(Ring& ring, const std::vector<Loop>& loops, std::size_t own, double least)
{
  double most = 0.0; // mm
  for (const Vector3& p : loops[own])
  {
    double distance = Infinity; // mm
    for (std::size_t other = 0; other < loops.size(); ++other)
    {
      for (const Vector3& q : loops[other])
      {
        distance = other != own ? std::min(distance, (p - q).norm()) : distance;
      }
    }
    ring.Start = distance > most ? p : ring.Start;
    most = std::max(most, distance);
  }
  return most > least;
}

/// Two or three rings anywhere, wavy.
NearVictim RingsAnywhere(Random& random)
{
  NearVictim victim;
  const double error = 0.5 * std::pow(10.0, random.Between(-0.3, 0.3));
  const double size = error * random.Between(2.5, 4.0);
  const Index count = 2 + random.Below(2);
  std::vector<Loop> loops;
  for (Index i = 0; i < count; ++i)
  {
    const Vector3 n = AnyDirection(random);
    const Vector3 x = n.cross(AnyDirection(random)).normalized();
    const Vector3 center = random.InCube(0.7 * size);
    Loop loop = Circle(
      center, x, n.cross(x), size * random.Between(1.0, 1.3), error * random.Between(0.25, 0.6));
    const double wave = error * random.Between(0.0, 0.5);
    const double turns = static_cast<double>(2 + random.Below(9));
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const double angle =
        turns * 2.0 * Pi * static_cast<double>(k) / static_cast<double>(loop.size());
      loop[k] += wave * (std::cos(angle) * n + std::sin(angle) * (loop[k] - center).normalized());
    }
    const Surface tube = Tube(loop, error * random.Between(0.04, 0.12), 3 + random.Below(4));
    victim.Surface = i == 0 ? tube : Together(victim.Surface, tube);
    victim.Rings.push_back({ { center, n }, center });
    loops.push_back(loop);
  }
  victim.Error = error;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!FindStart(victim.Rings[i], loops, i, 2.6 * error))
    {
      return RingsAnywhere(random);
    }
  }
  return victim;
}

/// A box, or its bottom alone, in cells; z = 0 at the bottom and 1 at the top.
Surface FlatPart(Index cells, bool isOpen)
{
  Surface part = isOpen ? Grid(cells) : FlatPlate(cells);
  Vector3 low = part.Points[0];
  for (const Vector3& p : part.Points)
  {
    low = low.cwiseMin(p);
  }
  return Moved(part, -low);
}

Surface Speck(Random& random, const Vector3& at, double size)
{
  Surface speck = Scaled(Moved(Tetrahedron(), Vector3::Constant(-0.25)), size);
  return Moved(random.Below(4) == 0 ? TurnedInsideOut(speck) : speck, at);
}

/// Plates above each other, all lengths in mm.
class PlateStack
{
public:
  explicit PlateStack(Random& random)
    : Numbers(random)
    , Error(0.5 * std::pow(10.0, random.Between(-0.3, 0.3)))
    , Cells(6 + random.Below(6))
    , Cell(this->Error * random.Between(1.0, 1.8))
    , Wave(this->Error * random.Between(0.0, 1.5))
    , AlongX(random.Between(0.25, 1.5) / this->Error)
    , AlongY(random.Between(0.25, 1.5) / this->Error)
  {
  }

  NearVictim Make()
  {
    const Index count = 1 + this->Numbers.Below(3);
    for (Index i = 0; i < count; ++i)
    {
      this->AddPlate(i, count);
    }
    for (const bonedecimate::Surface& speck : this->Specks)
    {
      this->Victim.Surface = Together(this->Victim.Surface, speck);
    }
    const double half = 0.5 * this->Cell * this->Cells;
    this->Victim.Error = this->Error;
    this->Victim.Middle = { { half, half, 0.0 }, Vector3::UnitZ() };
    this->Victim.Radius = half - 2.2 * this->Error;
    return this->Victim;
  }

private:
  double WaveAt(double x, double y) const
  {
    return this->Wave * std::sin(this->AlongX * x) * std::cos(this->AlongY * y);
  }

  void AddPlate(Index i, Index count)
  {
    const bool isOpen = this->Numbers.Below(3) == 0;
    const double thickness = this->Error * this->Numbers.Between(0.05, 0.9);
    const double gap = this->Error * this->Numbers.Between(0.05, 0.9); // to the next one
    const double noise = this->Numbers.Below(2) == 0 ? 0.0 : 0.4 * std::min(gap, thickness);
    bonedecimate::Surface plate = FlatPart(this->Cells, isOpen);
    for (Vector3& p : plate.Points)
    {
      const double x = this->Cell * p[0];
      const double y = this->Cell * p[1];
      const double up = this->Height + this->WaveAt(x, y) + thickness * p[2];
      p = Vector3(x, y, up + this->Numbers.Between(-noise, noise));
    }
    this->Victim.Surface = i == 0 ? plate : Together(this->Victim.Surface, plate);
    this->Height += isOpen ? 0.0 : thickness;
    if (this->Numbers.Below(2) == 0)
    {
      this->AddSpeck(i, count, gap);
    }
    this->Height += gap;
    for (Index lower = 0; lower < i; ++lower)
    {
      this->AddView(lower, i, 1.0);
      this->AddView(i, lower, -1.0);
    }
  }

  /// Above a plate, in the middle of all.
  void AddSpeck(Index plate, Index count, double gap)
  {
    const double x = this->Cell * (this->Cells / 2 + this->Numbers.Below(3) - 1);
    const double y = this->Cell * (this->Cells / 2 + this->Numbers.Below(3) - 1);
    const Vector3 at(x, y, this->Height + 0.5 * gap + this->WaveAt(x, y));
    this->Specks.push_back(Speck(this->Numbers, at, gap * this->Numbers.Between(0.05, 0.4)));
    for (Index other = 0; other < count; ++other)
    {
      this->AddView(
        count + static_cast<Index>(this->Specks.size()) - 1, other, other <= plate ? -1.0 : 1.0);
    }
  }

  void AddView(Index from, Index to, double sign)
  {
    this->Victim.Views.push_back(
      { static_cast<std::size_t>(from), static_cast<std::size_t>(to), sign * Vector3::UnitZ() });
  }

  Random& Numbers;
  double Error;
  Index Cells;
  double Cell;
  double Wave;
  double AlongX; // 1/mm
  double AlongY;
  double Height = 0.0;
  std::vector<bonedecimate::Surface> Specks;
  NearVictim Victim;
};

/// Up to three plates that follow the same waves, with specks in the gaps.
NearVictim NearPlates(Random& random)
{
  return PlateStack(random).Make();
}

/// Spheres in each other, or lumps of the same kind, with gaps near the error.
NearVictim NearShells(Random& random)
{
  NearVictim victim;
  const int levels = 2;
  const double radius = 10.0;
  victim.Error = radius * std::pow(10.0, random.Between(-1.7, -0.7));
  const double roughness = random.Between(0.0, 0.3);
  const auto seed = static_cast<std::uint64_t>(random.Below(1000));
  double scale = 1.0;
  const Index count = 2 + random.Below(3);
  for (Index i = 0; i < count; ++i)
  {
    Surface shell = BumpySphere(levels, radius * scale, roughness, seed);
    shell = random.Below(2) == 0 ? shell : TurnedInsideOut(shell);
    victim.Surface = i == 0 ? shell : Together(victim.Surface, shell);
    scale *= 1.0 - victim.Error / radius * random.Between(0.1, 1.2);
  }
  return victim;
}

/// A lump with spikes and pits, and tetrahedra near it: within its spikes, in its pits, above and below its surface.
NearVictim Spikes(Random& random)
{
  NearVictim victim;
  const double radius = 10.0;
  const double error = radius * std::pow(10.0, random.Between(-1.7, -0.5));
  victim.Error = error;
  Surface lump =
    BumpySphere(2 + random.Below(2), radius, random.Between(0.0, 0.1), random.Below(1000));
  const auto numberOfPoints = static_cast<Index>(lump.Points.size());
  std::vector<Surface> specks;
  for (Index left = 1 + random.Below(6); left > 0; --left)
  {
    Vector3& tip = lump.Points[static_cast<std::size_t>(random.Below(numberOfPoints))];
    const Vector3 up = tip.normalized() * (random.Below(2) == 0 ? 1.0 : -1.0);
    const double height = random.Below(3) == 0 ? 0.0 : error * random.Between(0.2, 1.5);
    tip += height * up;
    const double distance = error * random.Between(0.05, 0.8);
    specks.push_back(Speck(random, tip - distance * up, distance * random.Between(0.02, 0.4)));
  }
  victim.Surface = random.Below(2) == 0 ? lump : TurnedInsideOut(lump);
  for (const Surface& speck : specks)
  {
    victim.Surface = Together(victim.Surface, speck);
  }
  return victim;
}

/// Turned and moved anywhere.
NearVictim Anywhere(Random& random, NearVictim victim)
{
  const Vector3 x = AnyDirection(random);
  const Vector3 y = x.cross(AnyDirection(random)).normalized();
  const Vector3 offset = random.InCube(std::pow(10.0, random.Between(0.0, 3.0)));
  const auto turn = [&, z = Vector3(x.cross(y))](Vector3& v)
  { v = (v[0] * x + v[1] * y + v[2] * z).eval(); };
  const auto toAnywhere = [&](Vector3& p)
  {
    turn(p);
    p += offset;
  };
  std::for_each(victim.Surface.Points.begin(), victim.Surface.Points.end(), toAnywhere);
  for (Ring& ring : victim.Rings)
  {
    toAnywhere(ring.Hole.Point);
    turn(ring.Hole.Direction);
    toAnywhere(ring.Start);
  }
  for (NearVictim::View& view : victim.Views)
  {
    turn(view.Direction);
  }
  toAnywhere(victim.Middle.Point);
  turn(victim.Middle.Direction);
  return victim;
}
}

NearVictim AnyNearVictim(Random& random)
{
  static const std::array<NearVictim (*)(Random&), 7> makers = { DippingRings, DippingRings,
    DippingRings, RingsAnywhere, NearPlates, NearShells, Spikes };
  const auto maker =
    makers[static_cast<std::size_t>(random.Below(static_cast<Index>(makers.size())))];
  NearVictim victim = maker(random);
  while (victim.Surface.Triangles.size() > MaxTriangles || CountCrossings(victim.Surface) > 0)
  {
    victim = maker(random);
  }
  return random.Below(2) == 0 ? Anywhere(random, std::move(victim)) : victim;
}
}
