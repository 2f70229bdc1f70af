// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tibia.h"

#include <cmath>

namespace phantom
{
namespace
{
constexpr double MarrowValue = -50.0;

/// Rounded triangle in section, its edge to the front. Half the width and half the depth change
/// along the bone.
double Shaft(const Point& p)
{
  static const std::vector<std::array<double, 2>> halfWidth{ { { 8.0, 25.0 } }, { { 28.0, 22.5 } },
    { { 48.0, 17.0 } }, { { 75.0, 14.0 } }, { { 110.0, 12.8 } }, { { 170.0, 12.3 } } };
  static const std::vector<std::array<double, 2>> halfDepth{ { { 8.0, 19.5 } }, { { 28.0, 18.5 } },
    { { 48.0, 16.5 } }, { { 75.0, 15.2 } }, { { 110.0, 14.2 } }, { { 170.0, 13.6 } } };
  const double below = -p.Z;
  const double a = Curve(halfWidth, below);
  const double b = Curve(halfDepth, below);
  const double x = p.X / a;
  const double y = p.Y / b;
  const double level = std::sqrt(x * x + y * y) + 1e-9;
  const double front = -y / level;
  const double triangle = (4.0 * front * front - 3.0) * front; // cosine of three times the angle
  const double radius = 1.0 + 0.11 * Fade(below, 20.0, 60.0) * triangle;
  const double slope = std::sqrt(x * x / (a * a) + y * y / (b * b)) / level + 1e-9;
  return (level - radius) / slope;
}

/// The joint surface: a shallow bowl on either side.
double Plateau(const Point& p)
{
  double height = 0.0;
  for (const double center : { -17.5, 17.5 })
  {
    const double x = (p.X - center) / 15.0;
    const double y = (p.Y - 0.5) / 18.0;
    const double rim = 1.0 - Clamped(x * x + y * y, 0.0, 1.0);
    height -= 2.6 * rim * rim;
  }
  return p.Z - height;
}

double Head(const Point& p)
{
  const double inner = Ellipsoid(p, { -16.0, 0.0, -14.0 }, { 20.0, 24.5, 21.0 });
  const double outer = Ellipsoid(p, { 16.0, 1.0, -14.0 }, { 19.5, 22.0, 19.0 });
  double head = SmoothUnion(inner, outer, 5.0);
  head = SmoothUnion(head, SmoothIntersection(Shaft(p), p.Z + 10.0, 4.0), 14.0);
  head = SmoothUnion(head, Ellipsoid(p, { 2.0, -15.0, -41.0 }, { 7.0, 7.5, 15.0 }), 8.0);
  head = SmoothIntersection(head, Plateau(p), 5.0);
  const double spines = SmoothUnion(Ellipsoid(p, { -4.6, 1.0, -3.0 }, { 5.0, 9.0, 8.5 }),
    Ellipsoid(p, { 4.6, -1.0, -3.0 }, { 4.6, 8.0, 7.5 }), 1.5);
  return SmoothUnion(head, spines, 6.0);
}

/**
 * HU of the spongy bone: connected plates, where a smooth noise crosses zero. With less
 * density they become thinner, and end where they would be thinner than a voxel and fall to crumbs.
 */
double Spongy(const Point& p, double density)
{
  if (density < 0.3)
  {
    return MarrowValue + 90.0 * density;
  }
  // Pulled about by other noises, or the plates would follow the grid of the first.
  const Point pulled =
    p + Point{ 2.2 * Noise(p, 5.5, 12), 2.2 * Noise(p, 5.5, 13), 2.2 * Noise(p, 5.5, 14) };
  const double noise = Noise(pulled, 4.8, 11);
  const double plate = 1.0 - Fade(noise < 0.0 ? -noise : noise, 0.0, 0.07 + 0.40 * density);
  return MarrowValue + 90.0 * density + 620.0 * Fade(density, 0.30, 0.50) * plate;
}
}

double Tibia(const Point& p)
{
  const double smooth = p.Z < -70.0 ? Shaft(p) : Head(p);
  return smooth + 0.30 * Noise(p, 6.0, 1) + 0.12 * Noise(p, 2.5, 2);
}

double Fibula(const Point& p)
{
  const double below = -p.Z;
  const double x = p.X - (30.0 - 0.03 * below);
  const double y = p.Y - (23.5 - 0.03 * below);
  const double shaft = std::sqrt(x * x + y * y) - 5.2;
  const double head = Ellipsoid(p, { 31.5, 23.5, -30.5 }, { 7.5, 7.5, 11.0 });
  return SmoothUnion(SmoothIntersection(shaft, p.Z + 32.0, 3.0), head, 8.0) +
    0.25 * Noise(p, 5.0, 3);
}

double TibiaValue(const Point& p, double depth)
{
  static const std::vector<std::array<double, 2>> thickness{ { { 0.0, 1.7 } }, { { 20.0, 1.4 } },
    { { 40.0, 1.8 } }, { { 65.0, 3.2 } }, { { 95.0, 4.2 } }, { { 170.0, 4.6 } } };
  const double below = -p.Z;
  const double inner = depth - Curve(thickness, below) - 0.35 * Noise(p, 4.0, 4);
  const double compact = 1250.0 - 350.0 * (1.0 - Fade(below, 10.0, 60.0));
  // Trabeculae are dense below the joint and thin out towards the shaft and the middle.
  const double density = (1.0 - Fade(below, 30.0, 66.0)) * (1.0 - 0.45 * Fade(inner, 4.0, 14.0));
  return compact + (Spongy(p, density) - compact) * Fade(inner, -0.6, 0.8);
}

double FibulaValue(double depth)
{
  return 1150.0 + (MarrowValue - 1150.0) * Fade(depth, 1.6, 2.8);
}
}
