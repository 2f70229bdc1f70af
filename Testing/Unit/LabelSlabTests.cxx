// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of a label map that comes in slabs: joined they are those of the whole, bit for bit.
#include "Labels/LabelMap/LabelSurfaces.h"

#include "LabelMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Where a point is and where in the grid it was extracted.
using Corner = std::pair<std::array<double, 3>, GridPoint>;
using LabeledTriangle = std::pair<std::array<Corner, 3>, BoundaryLabels>;

/// Appends the triangles, from the least corner of each on.
void Append(const LabelSurfaces& surfaces, std::vector<LabeledTriangle>& triangles)
{
  for (std::size_t i = 0; i < surfaces.Surface.Triangles.size(); ++i)
  {
    LabeledTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto point = static_cast<std::size_t>(surfaces.Surface.Triangles[i][k]);
      const Vector3& position = surfaces.Surface.Points[point];
      triangle.first[k] = { { position[0], position[1], position[2] },
        surfaces.Source.OfPoint[point] };
    }
    std::rotate(triangle.first.begin(),
      std::min_element(triangle.first.begin(), triangle.first.end()), triangle.first.end());
    triangle.second = surfaces.Source.OfTriangle[i];
    triangles.push_back(triangle);
  }
}

LabelSurfaces ExtractSlab(const LabelMap& map, LabelSurfaceOptions options, const LayerRange& slab)
{
  const auto layer = static_cast<std::size_t>(map.Grid.Dimensions[0]) *
    static_cast<std::size_t>(map.Grid.Dimensions[1]);
  // In a memory of its own: nothing beyond the slab can be read.
  const auto begin = map.Labels.begin() + static_cast<std::ptrdiff_t>(layer) * slab.First;
  const std::vector<std::int64_t> labels(
    begin, begin + static_cast<std::ptrdiff_t>(layer) * slab.Count());
  options.Slab = slab;
  return ExtractLabelSurfaces(MakeLabelImage(labels.data(), map.Grid), options);
}

void ExpectJoinedToBeTheWhole(const LabelMap& map, LabelSurfaceOptions options)
{
  options.Labels = { 1, 2, 3, 4 };
  std::vector<LabeledTriangle> whole;
  std::vector<LabeledTriangle> joined;
  Append(ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options), whole);
  for (Index first = 0, step = 1; first + 1 < map.Grid.Dimensions[2]; step = step % 4 + 1)
  {
    const Index last = std::min(first + step, map.Grid.Dimensions[2] - 1);
    const LabelSurfaces slab = ExtractSlab(map, options, { first, last });
    ASSERT_EQ(slab.Status, LabelSurfaceStatus::Good);
    EXPECT_EQ(slab.Source.Grid.Dimensions, map.Grid.Dimensions);
    Append(slab, joined);
    first = last;
  }
  std::sort(whole.begin(), whole.end());
  std::sort(joined.begin(), joined.end());
  EXPECT_GT(whole.size(), 1000U);
  EXPECT_TRUE(whole == joined) << whole.size() << " and " << joined.size() << " triangles";
}

TEST(LabelSlabs, JoinedTheyAreTheSurfacesOfTheWhole)
{
  for (const bool closed : { true, false })
  {
    LabelSurfaceOptions options;
    options.Closed = closed;
    options.Threads = 2;
    ExpectJoinedToBeTheWhole(NoiseLabels({ 9, 11, 23 }, 4, 7), options);
    LabelMap oblique = EllipsoidLabels({ 24, 20, 22 });
    oblique.Grid = ObliqueGrid({ 24, 20, 22 }, true);
    ExpectJoinedToBeTheWhole(oblique, options);
    oblique.Grid = Uneven(ShearedGrid({ 24, 20, 22 }, true));
    ExpectJoinedToBeTheWhole(oblique, options);
  }
}

TEST(LabelSlabs, OneSlabOfAllLayersIsTheWhole)
{
  const LabelMap map = NoiseLabels({ 8, 7, 9 }, 3, 5);
  LabelSurfaceOptions options;
  const LabelSurfaces whole =
    ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options);
  const LabelSurfaces slab = ExtractSlab(map, options, { 0, 8 });
  EXPECT_EQ(slab.Surface.Triangles, whole.Surface.Triangles);
  EXPECT_EQ(slab.Surface.Points, whole.Surface.Points);
  EXPECT_EQ(slab.Source.Values, whole.Source.Values);
}

TEST(LabelSlabs, NeedTwoLayersOfTheGrid)
{
  const LabelMap map = NoiseLabels({ 4, 4, 6 }, 3, 5);
  for (const LayerRange& slab :
    { LayerRange{ 2, 2 }, LayerRange{ 3, 2 }, LayerRange{ -1, 2 }, LayerRange{ 4, 6 } })
  {
    LabelSurfaceOptions options;
    options.Slab = slab;
    EXPECT_EQ(ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options).Status,
      LabelSurfaceStatus::BadSlab);
  }
}
}
