// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnCrossing.h"

#include "Geometry/WideInteger.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
int SignOfNumber(std::int64_t value)
{
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

/// Coordinates in the order (r, s, t) of a column.
class Ordered
{
public:
  explicit Ordered(std::size_t axis)
    : R(axis)
    , S((axis + 1) % 3)
    , T((axis + 2) % 3)
  {
  }
  FixedPoint operator()(const FixedPoint& point) const
  {
    return { point[this->R], point[this->S], point[this->T] };
  }

private:
  std::size_t R, S, T;
};

/// On which side of the edge from a to b the displaced column through p lies; 0 only if the edge is
/// along the column.
int SideOfEdge(const FixedPoint& a, const FixedPoint& b, const FixedPoint& p)
{
  const std::int64_t ds = b[1] - a[1];
  const std::int64_t dt = b[2] - a[2];
  const WideInteger area = WideInteger{ ds } * (p[2] - a[2]) - WideInteger{ dt } * (p[1] - a[1]);
  return area != 0 ? SignOf(area) : dt != 0 ? -SignOfNumber(dt) : SignOfNumber(ds);
}

/// The plane of a triangle, for comparing heights on one column.
class TrianglePlane
{
public:
  /// @param p On the column, at any height.  @param side The side of the column for all edges:
  /// the sign of the normal along it.
  TrianglePlane(
    const FixedPoint& a, const FixedPoint& b, const FixedPoint& c, const FixedPoint& p, int side)
    : U{ b[0] - a[0], b[1] - a[1], b[2] - a[2] }
    , V{ c[0] - a[0], c[1] - a[1], c[2] - a[2] }
    , AlongS(p[1] - a[1])
    , AlongT(p[2] - a[2])
    , Base(a[0])
    , Side(side)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double first = Product(this->U[(k + 1) % 3], this->V[(k + 2) % 3]);
      const double second = Product(this->U[(k + 2) % 3], this->V[(k + 1) % 3]);
      this->Normal[k] = first - second;
      this->Magnitude[k] = std::abs(first) + std::abs(second);
    }
    const double s = static_cast<double>(this->AlongS);
    const double t = static_cast<double>(this->AlongT);
    this->Rest = this->Normal[1] * s + this->Normal[2] * t;
    this->RestMagnitude = this->Magnitude[1] * std::abs(s) + this->Magnitude[2] * std::abs(t);
  }

  /// Approximate height at which the column meets the plane.
  double Height() const
  {
    return static_cast<double>(this->Base) -
      (this->Normal[0] == 0.0 ? 0.0 : this->Rest / this->Normal[0]);
  }

  /// Whether the displaced voxel center at that coordinate lies below the triangle.
  bool LiesBelow(std::int64_t center) const
  {
    constexpr double rounding = 1e-14; // about 20 times that of the sums
    const std::int64_t fromR = center - this->Base;
    const double r = static_cast<double>(fromR);
    const double height = this->Normal[0] * r + this->Rest;
    const double error = this->Magnitude[0] * std::abs(r) + this->RestMagnitude;
    const int sign = height > rounding * error ? 1
      : height < -rounding * error             ? -1
                                               : this->ExactSign(fromR);
    return sign != this->Side;
  }

private:
  static double Product(std::int64_t a, std::int64_t b)
  {
    return static_cast<double>(a) * static_cast<double>(b);
  }
  WideInteger ExactNormal(std::size_t k) const
  {
    return WideInteger{ this->U[(k + 1) % 3] } * this->V[(k + 2) % 3] -
      WideInteger{ this->U[(k + 2) % 3] } * this->V[(k + 1) % 3];
  }
  int ExactSign(std::int64_t fromR) const
  {
    const WideInteger r = this->ExactNormal(0);
    const WideInteger s = this->ExactNormal(1);
    const WideInteger t = this->ExactNormal(2);
    const int sign = SignOf(r * fromR + s * this->AlongS + t * this->AlongT);
    return sign != 0 ? sign : s != 0 ? SignOf(s) : t != 0 ? SignOf(t) : SignOf(r);
  }

  FixedPoint U, V;
  std::int64_t AlongS, AlongT, Base;
  int Side;
  std::array<double, 3> Normal{};
  std::array<double, 3> Magnitude{};
  double Rest = 0.0;
  double RestMagnitude = 0.0;
};

/// A guess of the highest center below the plane, within the bounds.
std::int64_t GuessBelow(const TrianglePlane& plane, std::int64_t first, std::int64_t last,
  const CenterLattice& lattice, std::size_t axis)
{
  if (lattice.IsEven(axis))
  {
    const double guess = std::floor(plane.Height() / static_cast<double>(UnitsOfVoxel));
    return guess < static_cast<double>(first) ? first - 1
      : guess > static_cast<double>(last)     ? last
                                              : static_cast<std::int64_t>(guess);
  }
  const double low = static_cast<double>(lattice.Coordinate(axis, first));
  const double high = static_cast<double>(lattice.Coordinate(axis, last));
  const double height = plane.Height();
  return !(height >= low) ? first - 1
    : height > high       ? last
                          : lattice.AtOrBelow(axis, static_cast<std::int64_t>(height));
}

std::int64_t MaxBelow(const TrianglePlane& plane, std::int64_t low, std::int64_t high,
  const CenterLattice& lattice, std::size_t axis)
{
  const std::int64_t first = lattice.AtOrAbove(axis, low);
  // a displaced center at the top is above
  const std::int64_t last = lattice.AtOrAbove(axis, high) - 1;
  const auto liesBelow = [&](std::int64_t center)
  { return plane.LiesBelow(lattice.Coordinate(axis, center)); };
  std::int64_t below = GuessBelow(plane, first, last, lattice, axis);
  while (below < last && liesBelow(below + 1))
  {
    ++below;
  }
  while (below >= first && !liesBelow(below))
  {
    --below;
  }
  return below;
}
}

ColumnCrossing CrossColumn(const FixedTriangle& corners, const FixedBox& box, const Column& column,
  const CenterLattice& lattice)
{
  const Ordered order(column.Axis);
  const FixedPoint low = order(box.Low);
  const FixedPoint high = order(box.High);
  const FixedPoint p = { low[0], lattice.Coordinate((column.Axis + 1) % 3, column.S),
    lattice.Coordinate((column.Axis + 2) % 3, column.T) };
  if (p[1] < low[1] || p[1] >= high[1] || p[2] < low[2] || p[2] > high[2])
  {
    return {};
  }
  const FixedPoint a = order(corners[0]);
  const FixedPoint b = order(corners[1]);
  const FixedPoint c = order(corners[2]);
  const int side = SideOfEdge(a, b, p);
  if (side == 0 || SideOfEdge(b, c, p) != side || SideOfEdge(c, a, p) != side)
  {
    return {};
  }
  const TrianglePlane plane(a, b, c, p, side);
  return { side, MaxBelow(plane, low[0], high[0], lattice, column.Axis) };
}
}
