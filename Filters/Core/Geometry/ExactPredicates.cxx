// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactPredicates.h"

#include "Expansion.h"

namespace bonedecimate
{
namespace
{
/// Shewchuk's (3 + 16 u) u, enlarged a little.
constexpr double PlaneFilterBound = 3.4e-16;

using ExactVector = std::array<ExactPair, 3>;

ExactVector ExactVectorFrom(const Vector3& a, const Vector3& b)
{
  return { ExactDifference(a[0], b[0]), ExactDifference(a[1], b[1]), ExactDifference(a[2], b[2]) };
}

bool IsRounded(const ExactVector& v)
{
  return v[0].Tail != 0.0 || v[1].Tail != 0.0 || v[2].Tail != 0.0;
}

/// Computes u x v. False if u, v or any step is rounded. Succeeds for points on a lattice or in
/// single precision.
bool FindExactCross(const ExactVector& u, const ExactVector& v, Vector3& cross)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const ExactPair first = ExactProduct(u[j].Head, v[k].Head);
    const ExactPair second = ExactProduct(u[k].Head, v[j].Head);
    const ExactPair difference = ExactDifference(first.Head, second.Head);
    if (first.Tail != 0.0 || second.Tail != 0.0 || difference.Tail != 0.0)
    {
      return false;
    }
    cross[static_cast<Eigen::Index>(i)] = difference.Head;
  }
  return !IsRounded(u) && !IsRounded(v);
}

/// Adds sign * a * b * c.
template <std::size_t Capacity>
void AddProduct(
  Expansion<Capacity>& sum, double sign, const ExactPair& a, const ExactPair& b, const ExactPair& c)
{
  for (const double x : { a.Tail, a.Head })
  {
    for (const double y : { b.Tail, b.Head })
    {
      if (x == 0.0 || y == 0.0)
      {
        continue;
      }
      const ExactPair xy = ExactProduct(sign * x, y);
      for (const double z : { c.Tail, c.Head })
      {
        if (z != 0.0)
        {
          sum.AddProduct(xy.Tail, z);
          sum.AddProduct(xy.Head, z);
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int OrientedPlane::ExactSideOf(const Vector3& p) const
{
  const ExactVector u = ExactVectorFrom(this->B, this->A);
  const ExactVector v = ExactVectorFrom(this->C, this->A);
  const ExactVector w = ExactVectorFrom(p, this->A);
  Vector3 cross;
  if (!IsRounded(w) && FindExactCross(u, v, cross))
  {
    Expansion<6> height;
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      height.AddProduct(cross[i], w[static_cast<std::size_t>(i)].Head);
    }
    return height.Sign();
  }
  Expansion<192> height; // six products of three differences of two parts, four terms each
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    AddProduct(height, 1.0, u[j], v[k], w[i]);
    AddProduct(height, -1.0, u[k], v[j], w[i]);
  }
  return height.Sign();
}

//------------------------------------------------------------------------------
int ProjectedOrientation(const Vector3& a, const Vector3& b, const Vector3& c, Eigen::Index axis)
{
  const Eigen::Index x = (axis + 1) % 3;
  const Eigen::Index y = (axis + 2) % 3;
  const double first = (b[x] - a[x]) * (c[y] - a[y]);
  const double second = (b[y] - a[y]) * (c[x] - a[x]);
  const double area = first - second;
  const double bound = PlaneFilterBound * (std::abs(first) + std::abs(second));
  if (std::abs(area) > bound || bound == 0.0)
  {
    return area > 0.0 ? 1 : area < 0.0 ? -1 : 0;
  }
  Expansion<16> exact; // two products of two differences of two parts, two terms each
  const std::array<ExactPair, 2> u = { ExactDifference(b[x], a[x]), ExactDifference(b[y], a[y]) };
  const std::array<ExactPair, 2> v = { ExactDifference(c[x], a[x]), ExactDifference(c[y], a[y]) };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double sign = i == 0 ? 1.0 : -1.0;
    for (const double p : { u[i].Tail, u[i].Head })
    {
      exact.AddProduct(sign * p, v[1 - i].Tail);
      exact.AddProduct(sign * p, v[1 - i].Head);
    }
  }
  return exact.Sign();
}
}
