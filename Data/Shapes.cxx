// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <cmath>
#include <cstddef>

namespace phantom
{
namespace
{
std::uint32_t Mixed(std::uint32_t bits)
{
  bits ^= bits >> 16;
  bits *= 0x7feb352dU;
  bits ^= bits >> 15;
  bits *= 0x846ca68bU;
  return bits ^ (bits >> 16);
}

std::int64_t Floor(double value)
{
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

double Mix(double a, double b, double weight)
{
  return a + (b - a) * weight;
}
}

Point operator+(const Point& a, const Point& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}

Point operator-(const Point& a, const Point& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

double Dot(const Point& a, const Point& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

double Clamped(double value, double least, double largest)
{
  return value < least ? least : (value > largest ? largest : value);
}

double Fade(double value, double begin, double end)
{
  const double weight = Clamped((value - begin) / (end - begin), 0.0, 1.0);
  return weight * weight * (3.0 - 2.0 * weight);
}

double Hash(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed)
{
  std::uint32_t bits = Mixed(seed + 0x9e3779b9U);
  bits = Mixed(bits + static_cast<std::uint32_t>(x));
  bits = Mixed(bits + static_cast<std::uint32_t>(y));
  bits = Mixed(bits + static_cast<std::uint32_t>(z));
  return static_cast<double>(bits) / 2147483647.5 - 1.0;
}

double Noise(const Point& p, double size, std::uint32_t seed)
{
  const std::array<double, 3> scaled{ { p.X / size, p.Y / size, p.Z / size } };
  std::array<std::int64_t, 3> cell;
  std::array<double, 3> weight;
  for (std::size_t i = 0; i < 3; ++i)
  {
    cell[i] = Floor(scaled[i]);
    weight[i] = Fade(scaled[i] - static_cast<double>(cell[i]), 0.0, 1.0);
  }
  std::array<double, 4> alongX;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const std::int64_t y = cell[1] + static_cast<std::int64_t>(corner & 1U);
    const std::int64_t z = cell[2] + static_cast<std::int64_t>(corner >> 1U);
    alongX[corner] = Mix(Hash(cell[0], y, z, seed), Hash(cell[0] + 1, y, z, seed), weight[0]);
  }
  return Mix(Mix(alongX[0], alongX[1], weight[1]), Mix(alongX[2], alongX[3], weight[1]), weight[2]);
}

double Ellipsoid(const Point& p, const Point& center, const Point& halfAxes)
{
  const Point q = p - center;
  const Point once{ q.X / halfAxes.X, q.Y / halfAxes.Y, q.Z / halfAxes.Z };
  const Point twice{ once.X / halfAxes.X, once.Y / halfAxes.Y, once.Z / halfAxes.Z };
  const double level = std::sqrt(Dot(once, once));
  const double slope = std::sqrt(Dot(twice, twice)) + 1e-9; // the center has none
  return level * (level - 1.0) / slope;
}

double SmoothUnion(double a, double b, double width)
{
  const double weight = Clamped(0.5 + 0.5 * (b - a) / width, 0.0, 1.0);
  return Mix(b, a, weight) - width * weight * (1.0 - weight);
}

double SmoothIntersection(double a, double b, double width)
{
  return -SmoothUnion(-a, -b, width);
}

double Curve(const std::vector<std::array<double, 2>>& knots, double at)
{
  const std::size_t last = knots.size() - 1;
  if (at <= knots.front()[0])
  {
    return knots.front()[1];
  }
  if (at >= knots.back()[0])
  {
    return knots.back()[1];
  }
  std::size_t i = 0;
  while (at > knots[i + 1][0])
  {
    ++i;
  }
  const auto slope = [&knots, last](std::size_t k)
  {
    const std::size_t before = k > 0 ? k - 1 : 0;
    const std::size_t after = k < last ? k + 1 : last;
    return (knots[after][1] - knots[before][1]) / (knots[after][0] - knots[before][0]);
  };
  const double width = knots[i + 1][0] - knots[i][0];
  const double s = (at - knots[i][0]) / width;
  const double r = 1.0 - s;
  return knots[i][1] * (1.0 + 2.0 * s) * r * r + knots[i + 1][1] * (3.0 - 2.0 * s) * s * s +
    width * s * r * (slope(i) * r - slope(i + 1) * s);
}

Pose::Pose(const Point& pivot, const Point& turn, const Point& shift)
  : Pivot(pivot)
  , Shift(shift)
{
  // The rotation of the quaternion (1, turn), which needs no sine.
  const double norm = 1.0 + Dot(turn, turn);
  const double x = turn.X;
  const double y = turn.Y;
  const double z = turn.Z;
  this->Columns[0] = { (1.0 + x * x - y * y - z * z) / norm, 2.0 * (x * y + z) / norm,
    2.0 * (x * z - y) / norm };
  this->Columns[1] = { 2.0 * (x * y - z) / norm, (1.0 - x * x + y * y - z * z) / norm,
    2.0 * (y * z + x) / norm };
  this->Columns[2] = { 2.0 * (x * z + y) / norm, 2.0 * (y * z - x) / norm,
    (1.0 - x * x - y * y + z * z) / norm };
}

Point Pose::Undo(const Point& p) const
{
  const Point q = p - this->Shift - this->Pivot;
  return Point{ Dot(this->Columns[0], q), Dot(this->Columns[1], q), Dot(this->Columns[2], q) } +
    this->Pivot;
}
}
