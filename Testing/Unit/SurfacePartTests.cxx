// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A surface that several runs simplify in parts: smoothed as a whole, and constrained where parts meet.
#include "LevelRuns.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Decimate.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Position = std::array<double, 3>;

const Surface& Torus()
{
  static const BinarySurface torus = MarchedShape(Oblique(TorusShape(6.0, 2.5)), 9.5, Cubic);
  return torus.Surface;
}

Position PositionOf(const Vector3& point)
{
  return { point.x(), point.y(), point.z() };
}

std::set<Position> PositionsOf(const std::vector<Vector3>& points)
{
  std::set<Position> positions;
  for (const Vector3& point : points)
  {
    positions.insert(PositionOf(point));
  }
  return positions;
}

Options Smoothed(double error)
{
  Options options = Error(error);
  options.AutomaticSmoothing = true;
  return options;
}

/// As a part run gets it: smoothed, and shared where x is small.
SurfacePart PartOf(const Surface& input, const Options& options)
{
  SurfacePart part;
  part.SmoothedPoints = SmoothOnly(input, options).Points;
  const auto [low, high] = std::minmax_element(input.Points.begin(), input.Points.end(),
    [](const Vector3& a, const Vector3& b) { return a.x() < b.x(); });
  for (const Vector3& point : input.Points)
  {
    part.IsShared.push_back(point.x() < low->x() + 0.2 * (high->x() - low->x()) ? 1 : 0);
  }
  return part;
}
}

TEST(SurfacePart, IsSmoothedAsARunWithoutReductionSmooths)
{
  Options options;
  options.AutomaticSmoothing = true;
  options.TargetReduction = 0.0;
  options.TargetReductionIsExplicit = true;
  const SmoothedInput smoothed = SmoothOnly(Torus(), options);
  EXPECT_EQ(smoothed.Points.size(), Torus().Points.size());
  EXPECT_GT(smoothed.Report.Smoothing.MaxDisplacement, 0.1);
  EXPECT_EQ(PositionsOf(smoothed.Points), PositionsOf(Decimate(Torus(), options).Surface.Points));
}

TEST(SurfacePart, KeepsSharedPointsAndTheirTrianglesWhereSmoothingPutThem)
{
  const Options options = Smoothed(0.5);
  const SurfacePart part = PartOf(Torus(), options);
  RunInputs inputs;
  inputs.Part = &part;
  const Result result = Decimate(Torus(), Error(0.5), {}, inputs);
  const Result free = Decimate(Torus(), options);
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_GT(result.Surface.Triangles.size(), free.Surface.Triangles.size());
  EXPECT_LT(result.Surface.Triangles.size(), 0.8 * Torus().Triangles.size());

  std::set<std::array<Position, 3>> triangles;
  for (const Triangle& c : result.Surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangles.insert({ PositionOf(result.Surface.Points[c[k]]),
        PositionOf(result.Surface.Points[c[(k + 1) % 3]]),
        PositionOf(result.Surface.Points[c[(k + 2) % 3]]) });
    }
  }
  int shared = 0;
  for (const Triangle& c : Torus().Triangles)
  {
    if (std::any_of(c.begin(), c.end(), [&](Index p) { return part.IsShared[p] != 0; }))
    {
      ++shared;
      EXPECT_EQ(triangles.count({ PositionOf(part.SmoothedPoints[c[0]]),
                  PositionOf(part.SmoothedPoints[c[1]]), PositionOf(part.SmoothedPoints[c[2]]) }),
        1U);
    }
  }
  EXPECT_GT(shared, 20);
}

TEST(SurfacePart, IsProvedAgainstTheSurfaceBeforeSmoothing)
{
  const SurfacePart part = PartOf(Torus(), Smoothed(0.3));
  RunInputs inputs;
  inputs.Part = &part;
  const Result result = Decimate(Torus(), Error(0.3), {}, inputs);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  const Certificate found = Certify(Torus(), result.Surface, {});
  EXPECT_LE(found.ReferenceToResult.Distance.Upper, 0.3);
  EXPECT_LE(found.ResultToReference.Distance.Upper, 0.3);
}
