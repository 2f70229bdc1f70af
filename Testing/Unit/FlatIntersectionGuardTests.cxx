// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The intersection guard where triangles lie in one plane, touch, or are very near: it neither
// hinders nor lets through.
#include "BruteForce.h"
#include "Crossings.h"
#include "Decimate/Edit/Editor.h"
#include "Geometry/ExactPredicates.h"
#include "GuardedOptions.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// One half of a ball of 18 voxels.
Surface HalfOfVoxelBall()
{
  return LabelSurface(
    { 20, 20, 20 }, { 0.5, 0.5, 0.5 },
    [](const std::array<Index, 3>& voxel)
    {
      const Vector3 from = Vector3(voxel[0] - 9.5, voxel[1] - 9.5, voxel[2] - 9.5);
      return from.norm() < 9.0 && voxel[0] < 10 ? 1 : 0;
    },
    1);
}
}

TEST(FlatIntersectionGuard, FlatPartsAreSimplifiedAsIfNothingWereNear)
{
  const std::vector<std::pair<Surface, std::size_t>> shapes = { { Scaled(Cube(12), 5.0), 12 },
    { Prism(6, 6, 9), 20 }, { CappedCylinder(24, 9), 92 }, { VoxelEllipsoid(), 0 },
    { HalfOfVoxelBall(), 0 }, { Grid(20), 2 } };
  for (const auto& [shape, expected] : shapes)
  {
    for (const Mode mode : { Mode::Fast, Mode::Balanced })
    {
      const double error = expected > 0 ? 1e-3 : 0.3;
      const Result with = Decimate(shape, Guarded(mode, error));
      const Result without = Decimate(shape, Guarded(mode, error, false));
      const std::size_t count = with.Surface.Triangles.size();
      EXPECT_LE(count, 1.03 * without.Surface.Triangles.size() + 4) << WordOf(mode) << expected;
      EXPECT_TRUE(expected == 0 || count == expected) << WordOf(mode) << count;
      EXPECT_EQ(CountCrossings(with.Surface), 0) << WordOf(mode) << expected;
      const std::size_t crossing = static_cast<std::size_t>(Rejection::Intersection);
      EXPECT_LE(with.Report.Edits.Rejections[crossing], 10) << WordOf(mode) << expected;
    }
  }
}

/// Two plates whose near sides lie in one plane, apart or overlapping there, and one that stands on
/// the other.
TEST(FlatIntersectionGuard, CoplanarPartsStayApartOrTouchNoMore)
{
  const Surface plate = Scaled(FlatPlate(6), 0.5);
  for (const Vector3& offset : { Vector3(3.25, 0.0, 0.0), Vector3(1.3, 0.7, 0.5) })
  {
    for (const Mode mode : { Mode::Fast, Mode::Balanced })
    {
      const Surface input = Together(plate, Moved(plate, offset));
      const std::int64_t before = CountCrossings(input);
      const Surface result = Decimate(input, Guarded(mode, 0.2)).Surface;
      EXPECT_LE(CountCrossings(result), before) << WordOf(mode) << offset.transpose();
      EXPECT_GE(LeastDistanceOfComponents(result), before == 0 ? 0.125 : 0.0);
      EXPECT_EQ(SplitComponents(result).size(), 2U);
      EXPECT_LT(result.Triangles.size(), input.Triangles.size() / 2) << WordOf(mode);
    }
  }
}

TEST(FlatIntersectionGuard, NearWallsAreNotTriedOverAndOver)
{
  const Surface spheres = NearSpheres(3, 0.001);
  const Result result = Decimate(spheres, Guarded(Mode::Fast, 0.1));
  EXPECT_EQ(CountCrossings(result.Surface), 0);
  EXPECT_GE(LeastDistanceOfComponents(result.Surface), 0.5 * LeastDistanceOfComponents(spheres));
  const std::size_t crossing = static_cast<std::size_t>(Rejection::Intersection);
  EXPECT_LT(result.Report.Edits.Rejections[crossing],
    static_cast<std::int64_t>(30 * spheres.Triangles.size()));
}

/// A cone whose tip touches a plate from below. As many pairs intersect when the tip goes through
/// the plate.
TEST(FlatIntersectionGuard, ATipThatTouchesAPlateDoesNotGoThroughIt)
{
  constexpr Index around = 8;
  Surface cone;
  cone.Points = { Vector3(0.25, 0.25, 0.0), Vector3(0.25, 0.25, -3.0) };
  for (Index i = 0; i < around; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / around;
    cone.Points.emplace_back(0.25 + std::cos(angle), 0.25 + std::sin(angle), -3.0);
    const Index here = 2 + i;
    const Index next = 2 + (i + 1) % around;
    cone.Triangles.push_back({ 0, here, next });
    cone.Triangles.push_back({ 1, next, here });
  }
  Surface plate;
  plate.Points = { Vector3(-4.0, -4.0, 0.0), Vector3(4.0, -4.0, 0.0), Vector3(0.0, 4.0, 0.0) };
  plate.Triangles = { { 0, 1, 2 } };
  const CleanSurface clean = Clean(Together(cone, plate), true);
  EditorSettings settings;
  settings.GuardsIntersections = true;
  settings.Bound = ErrorBoundSettings{ 0.5 };
  Editor editor(clean, settings);
  const Vector3 tip = editor.Mesh().Position(0);
  ASSERT_EQ(tip + clean.Origin, cone.Points[0]);
  EditWorkspace work;
  EXPECT_EQ(editor.Try(MoveTo(0, tip + Vector3(0.0, 0.0, 0.1)), work), Rejection::Intersection);
  EXPECT_TRUE(editor.Try(MoveTo(0, tip - Vector3(0.0, 0.0, 0.1)), work).IsAccepted());
}

namespace
{
/// A tent of three triangles, its tip the first point, and what is beside it.
Surface Tent(const Surface& other)
{
  Surface tent;
  tent.Points = { Vector3(0, 0, -1), Vector3(2, -2, -2), Vector3(2, 2, -2), Vector3(-3, 0, -2) };
  tent.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 } };
  return Together(tent, other);
}

Surface OneTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Surface one;
  one.Points = { a, b, c };
  one.Triangles = { { 0, 1, 2 } };
  return one;
}

/// The last triangle is an oblique roof above the tip.
Surface TentUnderARoof(const Vector3& offset)
{
  return Moved(
    Tent(OneTriangle(Vector3(7, -9, -4.1), Vector3(3, 11, 2.3), Vector3(-9, -2, 1.7))), offset);
}

EditorSettings GuardingNoGaps()
{
  EditorSettings settings;
  settings.GuardsIntersections = true;
  settings.GuardsGaps = false;
  settings.Bound = ErrorBoundSettings{ 10.0 };
  return settings;
}
}

/// Positions relative to the local origin have other last bits than those that are written.
TEST(FlatIntersectionGuard, DecidesForTheCoordinatesThatAreWritten)
{
  const Surface input = TentUnderARoof(Vector3(0.1, -1.0 / 3.0, 2.7));
  const CleanSurface clean = Clean(input, true);
  EditorSettings settings = GuardingNoGaps();
  settings.Input = &input;
  Editor editor(clean, settings);
  EditWorkspace work;
  const std::vector<Vector3>& local = clean.Surface.Points;
  const OrientedPlane localRoof(local[4], local[5], local[6]);
  const OrientedPlane roof(input.Points[4], input.Points[5], input.Points[6]);
  const Vector3 normal = (local[5] - local[4]).cross(local[6] - local[4]);
  Random random(1);
  int differ = 0;
  for (int i = 0; i < 4000; ++i)
  {
    Vector3 p = local[0] + random.InCube(0.5);
    p[2] -= normal.dot(p - local[4]) / normal[2];
    const int side = roof.SideOf(p + clean.Origin);
    ASSERT_EQ(editor.Try(MoveTo(0, p), work).IsAccepted(), side == roof.SideOf(input.Points[0]))
      << i;
    ASSERT_TRUE(editor.Try(MoveTo(0, local[0]), work).IsAccepted());
    differ += side != localRoof.SideOf(p) ? 1 : 0;
  }
  EXPECT_GT(differ, 10);
}

/// A roof in double precision that never moves is written in single precision like the tent below
/// it.
TEST(FlatIntersectionGuard, DecidesForPointsThatNeverMoveAsTheyAreRounded)
{
  const Surface input = TentUnderARoof(Vector3(100.1, -1.0 / 3.0, 2.7));
  const CleanSurface clean = Clean(input, true);
  EditorSettings settings = GuardingNoGaps();
  settings.Input = &input;
  settings.Bound->Rounding.ToSingle = true;
  settings.Bound->Origin = clean.Origin;
  Editor editor(clean, settings);
  EditWorkspace work;
  const OrientedPlane ofInput(input.Points[4], input.Points[5], input.Points[6]);
  const OrientedPlane asWritten(RoundedToSingle(input.Points[4]), RoundedToSingle(input.Points[5]),
    RoundedToSingle(input.Points[6]));
  const Vector3 normal =
    (input.Points[5] - input.Points[4]).cross(input.Points[6] - input.Points[4]);
  const int below = asWritten.SideOf(input.Points[0]);
  Random random(1);
  int differ = 0;
  for (int i = 0; i < 4000; ++i)
  {
    Vector3 p = input.Points[0] + random.InCube(0.5);
    p[2] -= normal.dot(p - input.Points[4]) / normal[2];
    p = RoundedToSingle(p);
    const int side = asWritten.SideOf(p);
    ASSERT_EQ(editor.Try(MoveTo(0, p - clean.Origin), work).IsAccepted(), side == below) << i;
    ASSERT_TRUE(editor.Try(MoveTo(0, clean.Surface.Points[0]), work).IsAccepted());
    differ += side != ofInput.SideOf(p) ? 1 : 0;
  }
  EXPECT_GT(differ, 100);
}

/// A needle pierces the tent all the time.
TEST(FlatIntersectionGuard, APairThatIntersectsAllowsNoOtherOne)
{
  const Surface needle =
    OneTriangle(Vector3(0.8, 0.0, -1.8), Vector3(2.5, 0.0, -0.5), Vector3(2.5, 0.1, -0.5));
  const Surface roof = OneTriangle(Vector3(-9, -9, 0), Vector3(9, -9, 0), Vector3(0, 9, 0));
  const Surface input = Tent(Together(needle, roof));
  ASSERT_EQ(CountCrossings(input), 1);
  const CleanSurface clean = Clean(input, true);
  Editor editor(clean, GuardingNoGaps());
  EditWorkspace work;
  const Vector3 tip = editor.Mesh().Position(0);
  EXPECT_EQ(editor.Try(MoveTo(0, tip + Vector3(0.0, 0.0, 1.0)), work), Rejection::Intersection);
  EXPECT_TRUE(editor.Try(MoveTo(0, tip + Vector3(0.0, 0.0, 0.9)), work).IsAccepted());
}
