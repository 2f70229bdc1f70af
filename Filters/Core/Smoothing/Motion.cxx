// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Motion.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr int MaxHalvingsOfTime = 8;
/// Bound of the rounding of products, relative to the coordinates.
constexpr double Rounding = 1e-12;

/// Whether all corners of the second triangle lie farther along the direction than those of the
/// first.
bool Separates(const Vector3& direction, const TrianglesInTime& at)
{
  double lastOfFirst = -std::numeric_limits<double>::infinity();
  double firstOfSecond = std::numeric_limits<double>::infinity();
  double scale = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    lastOfFirst = std::max(lastOfFirst, Dot(direction, at.First[i]));
    firstOfSecond = std::min(firstOfSecond, Dot(direction, at.Second[i]));
    scale =
      std::max({ scale, at.First[i].cwiseAbs().maxCoeff(), at.Second[i].cwiseAbs().maxCoeff() });
  }
  return firstOfSecond - lastOfFirst > Rounding * scale * direction.lpNorm<1>();
}

TrianglesInTime Between(const TrianglesInTime& before, const TrianglesInTime& after)
{
  TrianglesInTime middle;
  for (std::size_t i = 0; i < 3; ++i)
  {
    middle.First[i] = 0.5 * (before.First[i] + after.First[i]);
    middle.Second[i] = 0.5 * (before.Second[i] + after.Second[i]);
  }
  return middle;
}

bool StayApart(const TrianglesInTime& before, const TrianglesInTime& after, int halvings)
{
  for (const TrianglesInTime* at : { &before, &after })
  {
    const Vector3 direction = ShortestConnection(at->First, at->Second).FromAToB;
    if (Separates(direction, before) && Separates(direction, after))
    {
      return true;
    }
  }
  if (halvings == 0)
  {
    return false;
  }
  const TrianglesInTime middle = Between(before, after);
  return !Meet(PlaneTriangle(middle.First), PlaneTriangle(middle.Second)) &&
    StayApart(before, middle, halvings - 1) && StayApart(middle, after, halvings - 1);
}
}

bool StayApart(const TrianglesInTime& before, const TrianglesInTime& after)
{
  const bool isStill = before.First == after.First && before.Second == after.Second;
  return isStill || StayApart(before, after, MaxHalvingsOfTime);
}
}
