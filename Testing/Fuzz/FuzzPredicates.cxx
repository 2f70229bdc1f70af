// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzPredicates.cxx
 * @brief Fuzzes the exact predicates: they must agree with rational numbers.
 *
 *     bytes:  which predicate; for floating-point numbers a scale, an offset, and coordinates on a
 *             small lattice; then whether points are combinations of others, so that they are
 *             collinear or coplanar, and how many floating-point numbers farther they are moved;
 *             for fixed-point numbers voxels and fractions of which most are 0, a half or a unit
 *             away from them
 */
#include "Bytes.h"
#include "Geometry/ExactPredicates.h"
#include "Labels/VoxelGuard/ColumnCrossing.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace bonedecimate;
using bonedecimate::testsupport::Bytes;

namespace
{
using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

void Demand(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
  }
}

RationalPoint RationalOf(const Vector3& p)
{
  return { Rational(p[0]), Rational(p[1]), Rational(p[2]) };
}

RationalPoint Minus(const RationalPoint& a, const RationalPoint& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// A coordinate of u x v.
Rational Cross(const RationalPoint& u, const RationalPoint& v, std::size_t axis)
{
  const std::size_t s = (axis + 1) % 3;
  const std::size_t t = (axis + 2) % 3;
  return u[s] * v[t] - u[t] * v[s];
}

Rational Dot(const RationalPoint& normal, const RationalPoint& u)
{
  return normal[0] * u[0] + normal[1] * u[1] + normal[2] * u[2];
}

RationalPoint Normal(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c)
{
  const RationalPoint u = Minus(b, a);
  const RationalPoint v = Minus(c, a);
  return { Cross(u, v, 0), Cross(u, v, 1), Cross(u, v, 2) };
}

/// Moves a number to one of its neighbors, up to the third; one in two stays.
double Nudged(double x, int byte)
{
  const int steps = byte < 128 ? 0 : byte % 7 - 3;
  for (int i = 0; i < std::abs(steps); ++i)
  {
    x = std::nextafter(x, steps < 0 ? -1e300 : 1e300);
  }
  return std::abs(x) < 1e-60 ? 0.0 : x; // the predicates are exact from 1e-70 on
}

class AnyPoints
{
public:
  explicit AnyPoints(Bytes& bytes)
    : Source(bytes)
    , Scale(std::ldexp(bytes.Switch() ? 1.0 : 0.7, bytes.Below(120) - 60))
  {
    constexpr std::array<double, 6> offsets = { 0.0, 1.0, -1e3, 1e8, -4503599627370496.0, 1e15 };
    for (double& offset : this->Offset)
    {
      offset = this->Scale * offsets[static_cast<std::size_t>(bytes.Below(offsets.size()))];
    }
  }

  Vector3 Next()
  {
    Vector3 p;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const int byte = this->Source.Next();
      const double small = (byte - 128) / (byte % 2 == 0 ? 8.0 : 3.0);
      p[k] = Nudged(this->Offset[k] + this->Scale * small, this->Source.Next());
    }
    return p;
  }

  /// One of the points, a point on the line through a and b, a point in the plane of a, b and c, or
  /// another.
  Vector3 Next(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const int kind = this->Source.Below(5);
    const double s = (this->Source.Next() - 128) / 16.0;
    const double t = (this->Source.Next() - 128) / 16.0;
    Vector3 p = kind == 0 ? a
      : kind == 1         ? b
      : kind == 2         ? Vector3(a + s * (b - a))
      : kind == 3         ? Vector3(a + s * (b - a) + t * (c - a))
                          : this->Next();
    for (double& x : p)
    {
      x = Nudged(x, this->Source.Next());
    }
    return p;
  }

private:
  Bytes& Source;
  double Scale;
  Vector3 Offset;
};

void FuzzOrientations(Bytes& bytes)
{
  AnyPoints points(bytes);
  const Vector3 a = points.Next();
  const Vector3 b = points.Next();
  const Vector3 c = points.Next(a, b, b);
  const Vector3 d = points.Next(a, b, c);
  const RationalPoint origin = RationalOf(a);
  const RationalPoint normal = Normal(origin, RationalOf(b), RationalOf(c));
  const int expected = Dot(normal, Minus(RationalOf(d), origin)).sign();
  Demand(Orientation(a, b, c, d) == expected, "the orientation of four points");
  Demand(Orientation(b, a, c, d) == -expected, "the orientation of exchanged points");
  const OrientedPlane plane(a, b, c);
  Demand(plane.SideOf(d) == expected && plane.SideOf(a) == 0, "the side of a plane");
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    Demand(ProjectedOrientation(a, b, c, axis) == normal[static_cast<std::size_t>(axis)].sign(),
      "the orientation of projected points");
  }
}

/// Voxel coordinates near centers of voxels, in the middle between them, or anywhere.
std::int64_t AnyFixed(Bytes& bytes, std::int64_t voxel, int size)
{
  const std::int64_t base = (voxel + bytes.Below(size)) * UnitsOfVoxel;
  const int kind = bytes.Below(8);
  return kind < 3 ? base
    : kind == 3   ? base + 1
    : kind == 4   ? base - 1
    : kind == 5   ? base + UnitsOfVoxel / 2
    : kind == 6   ? base + bytes.Next() * (UnitsOfVoxel / 240)
                  : base + bytes.Next() * 4194301 + bytes.Next() * 16381 + bytes.Next();
}

/// Voxels.
RationalPoint RationalOf(const FixedPoint& p)
{
  return { Rational(p[0], UnitsOfVoxel), Rational(p[1], UnitsOfVoxel),
    Rational(p[2], UnitsOfVoxel) };
}

/// The center of a column at height 0, displaced; the powers of e are far less than all differences
/// of rational numbers.
RationalPoint DisplacedCenter(const Column& column)
{
  const Rational e(1, boost::multiprecision::cpp_int(1) << 400);
  RationalPoint p;
  p[column.Axis] = e * e * e;
  p[(column.Axis + 1) % 3] = column.S + e;
  p[(column.Axis + 2) % 3] = column.T + e * e;
  return p;
}

ColumnCrossing ExpectedCrossing(const FixedTriangle& fixed, const Column& column)
{
  const std::array<RationalPoint, 3> corners = { RationalOf(fixed[0]), RationalOf(fixed[1]),
    RationalOf(fixed[2]) };
  const RationalPoint p = DisplacedCenter(column);
  const RationalPoint normal = Normal(corners[0], corners[1], corners[2]);
  const int sign = normal[column.Axis].sign();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const RationalPoint& a = corners[k];
    const Rational side = Cross(Minus(corners[(k + 1) % 3], a), Minus(p, a), column.Axis);
    if (sign == 0 || side.sign() != sign)
    {
      return {};
    }
  }
  // Where the line through the displaced centers meets the plane, above the displaced center at
  // height 0.
  const Rational height = -Dot(normal, Minus(p, corners[0])) / normal[column.Axis];
  using boost::multiprecision::cpp_int;
  const cpp_int quotient = numerator(height) / denominator(height);
  const bool isLess = height < 0 && Rational(quotient) != height;
  return { sign, static_cast<std::int64_t>(quotient) - (isLess ? 1 : 0) };
}

void FuzzColumns(Bytes& bytes)
{
  const int size = 1 + bytes.Below(bytes.Below(4) == 0 ? 250 : 6);
  std::array<std::int64_t, 3> offset{};
  for (std::int64_t& voxel : offset)
  {
    voxel = bytes.Switch() ? bytes.Next() - 128 : (std::int64_t(bytes.Next()) - 128) * (1 << 20);
  }
  FixedTriangle corners;
  for (FixedPoint& corner : corners)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      corner[k] = AnyFixed(bytes, offset[k], size);
    }
  }
  FixedBox box(corners[0]);
  box.Add(corners[1]);
  box.Add(corners[2]);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t s = (axis + 1) % 3;
    const std::size_t t = (axis + 2) % 3;
    const Column column = { axis, offset[s] + bytes.Below(size), offset[t] + bytes.Below(size) };
    const ColumnCrossing expected = ExpectedCrossing(corners, column);
    const ColumnCrossing found = CrossColumn(corners, box, column);
    Demand(found.Sign == expected.Sign, "whether a column crosses a triangle");
    Demand(found.Sign == 0 || found.Below == expected.Below, "where a column crosses a triangle");
    const FixedTriangle turned = { corners[1], corners[0], corners[2] };
    const ColumnCrossing back = CrossColumn(turned, box, column);
    Demand(back.Sign == -found.Sign && back.Below == found.Below, "a triangle turned around");
  }
}

/// The integers are nearest to the position, but for rounding of sums and products.
void FuzzConversion(Bytes& bytes)
{
  VoxelGrid grid;
  AnyPoints points(bytes);
  grid.Origin = points.Next();
  for (double& spacing : grid.Spacing)
  {
    spacing = std::ldexp(1.0 + bytes.Next() / 256.0, bytes.Below(16) - 8);
  }
  const Vector3 position = grid.Origin + Vector3(bytes.Next(), bytes.Next(), bytes.Next()) / 7.0;
  const FixedPoint fixed = FixedPointFrame(grid).Convert(position);
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    const Rational exact =
      (Rational(position[i]) - Rational(grid.Origin[i])) / Rational(grid.Spacing[i]) * UnitsOfVoxel;
    const Rational error = abs(Rational(fixed[k]) - exact);
    const bool isFar = abs(exact) > Rational(UnitsOfVoxel) * UnitsOfVoxel * 2;
    Demand(
      isFar || error <= Rational(1, 2) + abs(exact) * Rational(rounding), "a position as integers");
    const std::int64_t above = CenterAtOrAbove(fixed[k]);
    const std::int64_t below = CenterAtOrBelow(fixed[k]);
    const Rational voxels(fixed[k], UnitsOfVoxel);
    Demand(isFar || (above >= voxels && above - 1 < voxels), "the center at or above");
    Demand(isFar || (below <= voxels && below + 1 > voxels), "the center at or below");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  switch (bytes.Below(5))
  {
    case 0:
      FuzzConversion(bytes);
      break;
    case 1:
    case 2:
      FuzzOrientations(bytes);
      break;
    default:
      FuzzColumns(bytes);
  }
  return 0;
}
