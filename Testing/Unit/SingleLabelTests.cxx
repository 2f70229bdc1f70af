// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The surface of one label: its triangles turned outward, vertices split where the label touches
// itself.
#include "Labels/LabelMap/SingleLabel.h"

#include "BruteForce.h"
#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
LabelSurfaces Extract(const LabelMap& map)
{
  return ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), {});
}

std::size_t NonManifoldPoints(const LabelSurfaces& surfaces, Index label)
{
  Surface whole = { surfaces.Surface.Points, {} };
  for (const Index t :
    ExtractLabel(surfaces.Surface, surfaces.Source.OfTriangle, label).OriginalTriangle)
  {
    whole.Triangles.push_back(surfaces.Surface.Triangles[static_cast<std::size_t>(t)]);
  }
  return static_cast<std::size_t>(CountTopology(whole).NonManifoldPoints);
}
}

TEST(SingleLabel, HasTheTrianglesBetweenItAndAnyOtherLabel)
{
  const LabelSurfaces all = Extract(EllipsoidLabels({ 14, 12, 13 }));
  for (Index label = 0; label < 4; ++label)
  {
    const SingleLabelSurface single = ExtractLabel(all.Surface, all.Source.OfTriangle, label);
    std::size_t next = 0;
    for (std::size_t t = 0; t < all.Surface.Triangles.size(); ++t)
    {
      const BoundaryLabels& labels = all.Source.OfTriangle[t];
      if (labels[0] != label && labels[1] != label)
      {
        continue;
      }
      ASSERT_EQ(single.OriginalTriangle.at(next), static_cast<Index>(t));
      const Triangle& corners = single.Surface.Triangles[next++];
      const Triangle& original = all.Surface.Triangles[t];
      const bool isTurned = labels[1] == label;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t from = isTurned && k > 0 ? 3 - k : k;
        EXPECT_EQ(single.OriginalPoint[static_cast<std::size_t>(corners[k])], original[from]);
      }
    }
    EXPECT_EQ(next, single.Surface.Triangles.size());
    EXPECT_EQ(WhatIsWrong(single.Surface), "");
    EXPECT_EQ(single.OriginalPoint.size(), single.Surface.Points.size());
  }
}

TEST(SingleLabel, SplitsVerticesWhereItTouchesItself)
{
  const LabelSurfaces all = Extract(NoiseLabels({ 12, 12, 12 }, 5, 2));
  std::size_t before = 0;
  for (Index label = 0; label < 5; ++label)
  {
    before += NonManifoldPoints(all, label);
    const SingleLabelSurface single = ExtractLabel(all.Surface, all.Source.OfTriangle, label);
    EXPECT_EQ(CountTopology(single.Surface).NonManifoldPoints, 0);
    EXPECT_EQ(CountTopology(single.Surface).BoundaryEdges, 0);
  }
  EXPECT_GT(before, 0U);
}

TEST(SingleLabel, OfALabelThatDoesNotOccurIsEmpty)
{
  const LabelSurfaces all = Extract(EllipsoidLabels({ 14, 12, 13 }));
  EXPECT_TRUE(ExtractLabel(all.Surface, all.Source.OfTriangle, 9).Surface.Points.empty());
}

/// A book of three leaves has an edge of three triangles; it is split there.
TEST(SingleLabel, SplitsEdgesOfMoreThanTwoTriangles)
{
  const Surface book = { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } } };
  const SingleLabelSurface single = ExtractLabel(book, { { 0, 1 }, { 0, 1 }, { 0, 1 } }, 0);
  EXPECT_EQ(single.Surface.Points.size(), 9U);
}
