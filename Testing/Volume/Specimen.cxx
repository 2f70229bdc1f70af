// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Specimen.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::testing
{
using volume::Length;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double BallRadius = 4.0;
const Vector3 EllipsoidCentre{ { 112.0, -57.0, 431.0 } };
const Vector3 EllipsoidHalfAxes{ { 9.0, 6.0, 12.0 } };
const Vector3 BallCentre{ { 116.0, -44.0, 422.0 } };

Vector3 Difference(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// Such a grid that its middle is the middle of the specimen.
Scan CenterdScan(const std::array<Vector3, 3>& steps)
{
  const std::array<std::size_t, 3> size{ { 50, 52, 40 } };
  VolumeGeometry geometry;
  geometry.Steps = steps;
  geometry.Origin = { { 112.0, -53.0, 430.0 } };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      geometry.Origin[i] -= 0.5 * static_cast<double>(size[axis] - 1) * steps[axis][i];
    }
  }
  return ScanOf(size, geometry);
}

Vector3 Scaled(double factor, const Vector3& a)
{
  return { { factor * a[0], factor * a[1], factor * a[2] } };
}

/// Rows and columns of a rotation by a quaternion of small whole numbers: exact unit vectors but
/// for rounding.
std::array<Vector3, 3> TiltedSteps()
{
  const double norm = 36.0 + 1.0 + 4.0 + 4.0; // of the quaternion (6, 1, 2, -2)
  const std::array<Vector3, 3> axes{
    { { { (36.0 + 1.0 - 4.0 - 4.0) / norm, -20.0 / norm, -28.0 / norm } },
      { { 28.0 / norm, (36.0 - 1.0 + 4.0 - 4.0) / norm, 4.0 / norm } },
      { { 20.0 / norm, -20.0 / norm, (36.0 - 1.0 - 4.0 + 4.0) / norm } } }
  };
  return { { Scaled(0.8, axes[0]), Scaled(0.9, axes[1]), Scaled(1.3, axes[2]) } };
}
}

double SpecimenDistance(const Vector3& p)
{
  const Vector3 q = Difference(p, EllipsoidCentre);
  Vector3 once;
  Vector3 twice;
  for (std::size_t i = 0; i < 3; ++i)
  {
    once[i] = q[i] / EllipsoidHalfAxes[i];
    twice[i] = once[i] / EllipsoidHalfAxes[i];
  }
  const double level = Length(once);
  const double ellipsoid = level * (level - 1.0) / (Length(twice) + 1e-9);
  return std::min(ellipsoid, Length(Difference(p, BallCentre)) - BallRadius);
}

double SpecimenVolume()
{
  const Vector3& a = EllipsoidHalfAxes;
  return 4.0 / 3.0 * Pi * (a[0] * a[1] * a[2] + BallRadius * BallRadius * BallRadius);
}

Scan ScanOf(const std::array<std::size_t, 3>& size, const VolumeGeometry& geometry)
{
  Scan scan{ size, geometry, {} };
  for (std::size_t k = 0; k < size[2]; ++k)
  {
    for (std::size_t j = 0; j < size[1]; ++j)
    {
      for (std::size_t i = 0; i < size[0]; ++i)
      {
        const Vector3 index{ { double(i), double(j), double(k) } };
        Vector3 p = geometry.Origin;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          p[0] += index[axis] * geometry.Steps[axis][0];
          p[1] += index[axis] * geometry.Steps[axis][1];
          p[2] += index[axis] * geometry.Steps[axis][2];
        }
        const double value = SurfaceValue - 150.0 * SpecimenDistance(p);
        scan.Values.push_back(static_cast<short>(std::lround(std::clamp(value, -1000.0, 1200.0))));
      }
    }
  }
  return scan;
}

Scan UprightScan()
{
  return CenterdScan({ { { { 0.8, 0.0, 0.0 } }, { { 0.0, 0.9, 0.0 } }, { { 0.0, 0.0, 1.3 } } } });
}

Scan TiltedScan()
{
  return CenterdScan(TiltedSteps());
}

Scan MirroredScan()
{
  std::array<Vector3, 3> steps = TiltedSteps();
  steps[1] = Scaled(-1.0, steps[1]);
  return CenterdScan(steps);
}

Scan ShearedScan()
{
  std::array<Vector3, 3> steps = TiltedSteps();
  for (std::size_t i = 0; i < 3; ++i)
  {
    steps[2][i] += 0.2 * steps[1][i];
  }
  return CenterdScan(steps);
}
}
