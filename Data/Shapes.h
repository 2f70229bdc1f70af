// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shapes.h
 * @brief Solid shapes as distances: negative inside, about one per mm near the surface.
 *
 * The same bytes on every system: only + - * / and sqrt, no random numbers but hashes of integers.
 */
#ifndef BoneDecimate_Data_Shapes_h
#define BoneDecimate_Data_Shapes_h

#include <array>
#include <cstdint>
#include <vector>

namespace phantom
{
/// mm.
struct Point
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
double Dot(const Point& a, const Point& b);

double Clamped(double value, double least, double largest);

/// From 0 to 1 while the value goes from begin to end, without a kink at either.
double Fade(double value, double begin, double end);

/// A number from -1 to 1 for a position on the integer grid.
double Hash(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed);

/// From -1 to 1, smooth, with bumps of about that many mm.
double Noise(const Point& p, double size, std::uint32_t seed);

double Ellipsoid(const Point& p, const Point& center, const Point& halfAxes);

/// Union and intersection whose edges are rounded over that many mm.
double SmoothUnion(double a, double b, double width);
double SmoothIntersection(double a, double b, double width);

/// A curve through the knots, which ascend; constant beyond its ends.
double Curve(const std::vector<std::array<double, 2>>& knots, double at);

/// How a fragment was moved: turned about a pivot, then shifted.
class Pose
{
public:
  Pose() = default;

  /// @param turn Axis of the rotation; its length is the tangent of half the angle.
  Pose(const Point& pivot, const Point& turn, const Point& shift);

  /// Where the point lay before the fracture.
  Point Undo(const Point& p) const;

private:
  Point Pivot;
  Point Shift;
  std::array<Point, 3> Columns{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
};
}

#endif
