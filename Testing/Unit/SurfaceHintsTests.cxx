// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Random.h"
#include "Run/Decimate.h"
#include "Run/RunWarnings.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// All warnings of a run.
std::string WarningsOf(const Surface& surface)
{
  Options options;
  options.MeasureDistances = false;
  std::string all;
  for (const std::string& warning : RunWarnings(surface, Decimate(surface, options).Report, 1))
  {
    all += warning + "\n";
  }
  return all;
}

Surface Reversed(Surface surface)
{
  for (auto& triangle : surface.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  return surface;
}
}

TEST(SurfaceHints, AGoodSurfaceHasNone)
{
  EXPECT_EQ(WarningsOf(Icosphere(3, 10.0)), "");
}

TEST(SurfaceHints, AClosedSurfaceInsideOutIsTold)
{
  EXPECT_EQ(WarningsOf(Reversed(Icosphere(3, 10.0))),
    "1 closed part is inside out, and so is the result: turn the triangles, as vtkReverseSense or "
    "PyVista's flip_normals() do\n");
}

TEST(SurfaceHints, TheTwoSidesOfASurfaceAreTold)
{
  Surface surface = Icosphere(3, 10.0);
  const Surface back = Reversed(surface);
  surface.Triangles.insert(surface.Triangles.end(), back.Triangles.begin(), back.Triangles.end());
  EXPECT_NE(WarningsOf(surface).find("1280 triangles are the back of others: the surface is "
                                     "double-sided"),
    std::string::npos);
}

TEST(SurfaceHints, NearlyEqualPointsAreToldWithTheirDistance)
{
  const Surface whole = Icosphere(3, 10.0);
  Random random(3);
  Surface soup;
  for (const auto& triangle : whole.Triangles)
  {
    const auto first = static_cast<Index>(soup.Points.size());
    for (const Index corner : triangle)
    {
      const Vector3 shift(random.Uniform(), random.Uniform(), random.Uniform());
      soup.Points.push_back(whole.Points[static_cast<std::size_t>(corner)] + 1e-5 * shift);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  const std::string warnings = WarningsOf(soup);
  EXPECT_NE(warnings.find("3840 points lie apart from others by less than "), std::string::npos)
    << warnings;
  EXPECT_NE(warnings.find("joins such points, and its movement"), std::string::npos);
}
