// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FracturedLeg.h"

#include "Tibia.h"

#include <algorithm>

namespace phantom
{
namespace
{
constexpr double AirValue = -1000.0;
constexpr double FatValue = -95.0;
constexpr double MuscleValue = 45.0;
constexpr double Blur = 1.9; // mm over which the scanner smears an edge

const Point FractureCentre{ 0.0, 0.0, -82.0 };

/// Fraction of a voxel that lies inside of a surface at that signed distance, mm.
double InsideFraction(double distance)
{
  return 1.0 - Fade(distance, -0.5 * Blur, 0.5 * Blur);
}

double Jags(const Point& p)
{
  return 2.4 * Noise(p, 8.0, 21) + 0.8 * Noise(p, 3.2, 22) + 0.3 * Noise(p, 1.5, 23);
}

/// Negative above the fracture.
double AboveFracture(const Point& p)
{
  const Point normal{ 0.48, -0.30, 0.8245 };
  return -Dot(normal, p - FractureCentre) + Jags(p);
}

/// A wedge with its base on the inner and front side of the shaft.
double Butterfly(const Point& p)
{
  const double inwards = 0.85 * p.X + 0.53 * p.Y + 5.0;
  const double height = p.Z - (FractureCentre.Z + 3.0) - 0.35 * inwards;
  const double half = -1.25 * inwards;
  return 0.62 * ((height < 0.0 ? -height : height) - half) +
    0.5 * Jags(p + Point{ 40.0, 0.0, 0.0 });
}

/// A fragment of the tibia: distance to it, and its value, from where the point lay before the
/// fracture.
struct Sample
{
  double Distance = 1e3;
  double Value = MuscleValue;
};

void Take(Sample& nearest, double distance, double value)
{
  if (distance < nearest.Distance)
  {
    nearest.Distance = distance;
    nearest.Value = value;
  }
}

/// The greater of two: inside both.
double Both(double a, double b)
{
  return a > b ? a : b;
}

void TakeUpperPart(Sample& nearest, const Point& p)
{
  const double outside = Tibia(p);
  const double broken = p.Z < -40.0 ? Both(AboveFracture(p), -Butterfly(p)) : outside;
  Take(nearest, Both(outside, broken), TibiaValue(p, -outside));
}

void TakeLowerPart(Sample& nearest, const Point& p)
{
  static const Pose pose(FractureCentre, { 0.022, 0.025, 0.030 }, { 0.8, 2.4, -4.4 });
  const Point before = pose.Undo(p);
  const double outside = Tibia(before);
  const double broken = Both(-AboveFracture(before), -Butterfly(before));
  Take(nearest, Both(outside, broken), TibiaValue(before, -outside));
}

void TakeButterfly(Sample& nearest, const Point& p)
{
  static const Pose pose(FractureCentre, { 0.02, -0.05, 0.04 }, { -4.4, -2.8, 0.6 });
  const Point before = pose.Undo(p);
  const double outside = Tibia(before);
  Take(nearest, Both(outside, Butterfly(before)), TibiaValue(before, -outside));
}

void TakeChips(Sample& nearest, const Point& p)
{
  const double edges = 0.9 * Noise(p, 2.6, 31);
  const double chip = std::min(Ellipsoid(p, { 12.5, -18.5, -72.0 }, { 3.0, 2.2, 5.5 }),
    std::min(Ellipsoid(p, { 22.5, -5.0, -86.0 }, { 2.2, 3.0, 3.4 }),
      Ellipsoid(p, { -8.0, 21.5, -88.0 }, { 2.6, 2.0, 4.0 })));
  Take(nearest, chip + edges, 1000.0);
}

/// Skin, fat and muscle.
double SoftValue(const Point& p)
{
  const double skin = Ellipsoid({ p.X, p.Y, 0.0 }, { 3.0, 8.0, 0.0 }, { 52.0, 50.0, 1e3 });
  const double fat = 7.0 + 2.5 * Noise(p, 30.0, 41);
  const double muscle = FatValue + (MuscleValue - FatValue) * InsideFraction(skin + fat);
  const double inside = muscle + (20.0 - muscle) * (1.0 - InsideFraction(skin + 1.5));
  return AirValue + (inside - AirValue) * InsideFraction(skin);
}

bool IsNearBone(const Point& p)
{
  return Ellipsoid(p, { 2.0, 2.0, -70.0 }, { 50.0, 45.0, 600.0 }) < 0.0;
}
}

int LegLabel(const Point& p)
{
  if (!IsNearBone(p))
  {
    return 0;
  }
  if (Tibia(p) < 0.0)
  {
    return p.Z > -40.0 || AboveFracture(p) < 0.0 ? 1 : 2;
  }
  return Fibula(p) < 0.0 ? 3 : 0;
}

double LegValue(const Point& p)
{
  Sample nearest;
  if (IsNearBone(p))
  {
    if (p.Z > -125.0)
    {
      TakeUpperPart(nearest, p);
    }
    if (p.Z < -45.0)
    {
      TakeLowerPart(nearest, p);
    }
    if (p.Z < -45.0 && p.Z > -125.0)
    {
      TakeButterfly(nearest, p);
      TakeChips(nearest, p);
    }
    const double fibula = Fibula(p);
    Take(nearest, fibula, FibulaValue(-fibula));
  }
  const double soft = SoftValue(p);
  return soft + (nearest.Value - soft) * InsideFraction(nearest.Distance);
}
}
