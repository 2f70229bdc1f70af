// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The same surface with its points and triangles in another order has the same result up to
// indices. Equal points that are not merged, and equal triangles, keep the order of the input
// (SpatialOrder.h): these runs have none.
#include "BruteForce.h"
#include "Random.h"
#include "Run/Decimate.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
std::vector<Index> Shuffled(std::size_t count, Random& random)
{
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.Below(static_cast<Index>(i)))]);
  }
  return order;
}

/// Points and triangles in another order.
Surface Renumbered(const Surface& surface, std::uint64_t seed)
{
  Random random(seed);
  const std::vector<Index> newId = Shuffled(surface.Points.size(), random);
  Surface renumbered = surface;
  for (std::size_t p = 0; p < newId.size(); ++p)
  {
    renumbered.Points[static_cast<std::size_t>(newId[p])] = surface.Points[p];
  }
  const std::vector<Index> newIndex = Shuffled(surface.Triangles.size(), random);
  for (std::size_t t = 0; t < newIndex.size(); ++t)
  {
    Triangle& triangle = renumbered.Triangles[static_cast<std::size_t>(newIndex[t])];
    std::transform(surface.Triangles[t].begin(), surface.Triangles[t].end(), triangle.begin(),
      [&](Index corner) { return newId[static_cast<std::size_t>(corner)]; });
  }
  return renumbered;
}

using CornerPositions = std::array<std::array<double, 3>, 3>;

/// Sorted triangles as the positions of their corners, from the least one on, without indices.
std::vector<CornerPositions> WithoutNumbers(const Surface& surface)
{
  std::vector<CornerPositions> triangles;
  for (const Triangle& corners : surface.Triangles)
  {
    CornerPositions positions;
    std::transform(corners.begin(), corners.end(), positions.begin(),
      [&](Index corner)
      {
        const Vector3& p = surface.Points[static_cast<std::size_t>(corner)];
        return std::array<double, 3>{ p[0], p[1], p[2] };
      });
    std::rotate(
      positions.begin(), std::min_element(positions.begin(), positions.end()), positions.end());
    triangles.push_back(positions);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void ExpectTheSameUpToNumbers(const Surface& surface, const Options& options)
{
  const std::vector<CornerPositions> expected = WithoutNumbers(Decimate(surface, options).Surface);
  for (const std::uint64_t seed : { 1U, 2U, 3U })
  {
    EXPECT_EQ(WithoutNumbers(Decimate(Renumbered(surface, seed), options).Surface), expected)
      << WordOf(options.Mode) << ", order " << seed;
  }
}
}

TEST(Renumbering, ChangesNothingButNumbers)
{
  for (const Mode mode : AllModes())
  {
    ExpectTheSameUpToNumbers(BumpySphere(3, 10.0, 0.1, 5), InMode(mode, Reduction(0.8)));
    ExpectTheSameUpToNumbers(HeightField(14, 0.6, 3), InMode(mode, Reduction(0.8)));
  }
}

TEST(Renumbering, ChangesNoShape)
{
  for (const auto& [name, shape] : AllShapes())
  {
    SCOPED_TRACE(name);
    for (const Mode mode : AllModes())
    {
      ExpectTheSameUpToNumbers(shape, InMode(mode, Reduction(0.5)));
    }
  }
}

TEST(Renumbering, ChangesNothingWhereAnErrorIsProved)
{
  ExpectTheSameUpToNumbers(BumpySphere(2, 10.0, 0.1, 5), Error(0.3));
}

TEST(Renumbering, ChangesTheCostsOfNothingThatIsMeasured)
{
  Options options = Reduction(0.5);
  options.MeasureDistances = true;
  const Surface bone = BumpySphere(2, 10.0, 0.1, 5);
  const Report one = Decimate(bone, options).Report;
  const Report other = Decimate(Renumbered(bone, 4), options).Report;
  EXPECT_EQ(one.Output.Faces, other.Output.Faces);
  EXPECT_EQ(one.OutputToInput.PointMaximum, other.OutputToInput.PointMaximum);
}
