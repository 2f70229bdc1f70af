// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Levels compared with the recorded run, with its edits applied one by one, and with runs that stop
// there.
#include "Decimate/Edit/Editor.h"
#include "EditAlone.h"
#include "LevelRuns.h"
#include "Mesh/SpatialOrder.h"
#include "Proof/Measure/SurfaceDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Applies the collapses of the log one by one, with validity checks as in a run.
class OneByOne
{
public:
  OneByOne(const Surface& input, const EditLog& log)
    : Cleaned(Sorted(input))
    , MeshEditor(this->Cleaned, EditorSettings{ false, false, false })
    , Log(log)
  {
  }

  /// Applies collapses of the log up to that number. Returns how many were rejected.
  int GoTo(Index collapses)
  {
    int rejected = 0;
    for (; this->Done < collapses; ++this->Done)
    {
      const LoggedCollapse& next = this->Log.Collapses[static_cast<std::size_t>(this->Done)];
      Edit edit;
      edit.Edge = next.HalfEdge;
      edit.Keep = next.KeptVertex;
      edit.Position = next.Position;
      edit.KeepStays = next.Position == this->MeshEditor.Mesh().Position(next.KeptVertex);
      rejected += TryAlone(this->MeshEditor, edit).IsAccepted() ? 0 : 1;
    }
    return rejected;
  }

  /// The surface of the mesh after the collapses so far, in the order of the mesh.
  Surface Now() const
  {
    const Surface all = SurfaceOf(this->MeshEditor.Mesh());
    std::vector<Index> positions(all.Points.size(), None);
    for (const Triangle& corners : all.Triangles)
    {
      std::for_each(corners.begin(), corners.end(), [&](Index v) { positions[v] = 0; });
    }
    Surface now;
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      if (positions[v] != None)
      {
        positions[v] = static_cast<Index>(now.Points.size());
        now.Points.push_back(all.Points[v]);
      }
    }
    for (const Triangle& c : all.Triangles)
    {
      now.Triangles.push_back({ positions[c[0]], positions[c[1]], positions[c[2]] });
    }
    return now;
  }

private:
  static CleanSurface Sorted(const Surface& input)
  {
    CleanSurface clean = Clean(input, true);
    SortAlongCurve(clean);
    return clean;
  }

  CleanSurface Cleaned;
  Editor MeshEditor;
  const EditLog& Log;
  Index Done = 0;
};

/// Largest distance between points of the same index in both lists, mm.
double LargestMove(const Surface& a, const Surface& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.Points.size(); ++i)
  {
    largest = std::max(largest, (a.Points[i] - b.Points[i]).norm());
  }
  return largest;
}

Surface Mapped(Surface surface, const std::function<Vector3(const Vector3&)>& map)
{
  std::transform(surface.Points.begin(), surface.Points.end(), surface.Points.begin(), map);
  return surface;
}

double MaxDistance(const Surface& from, const Surface& to)
{
  const std::vector<double> distances = PointDistances(from.Points, BoundingTree(to), 1, {});
  return *std::max_element(distances.begin(), distances.end());
}
}

TEST(Levels, TheLastLevelIsTheResultOfTheRunAndTheFirstIsTheInput)
{
  for (const NamedSurface& shape : AllShapes())
  {
    for (const Mode mode : AllModes())
    {
      for (const bool isSingle : { false, true })
      {
        SCOPED_TRACE(shape.Name + " " + WordOf(mode));
        const Options options = InMode(mode, Reduction(0.7));
        const Recorded recorded = Record(shape.Surface, options, isSingle);
        ASSERT_TRUE(recorded.Levels.IsOpen());
        const Index last = recorded.Levels.NumberOfCollapses();
        EXPECT_EQ(last, recorded.Run.Report.Edits.Collapses);
        EXPECT_TRUE(SameBytes(recorded.Levels.At(last).Surface, recorded.Run.Surface));
        const std::vector<LoggedPatch>& patches = recorded.Levels.Log().Patches;
        if (patches.empty() || patches.front().Collapses > 0)
        {
          const Surface untouched =
            Decimate(shape.Surface, InMode(mode, Reduction(0.0)), {}, { isSingle }).Surface;
          EXPECT_TRUE(SameBytes(recorded.Levels.At(0).Surface, untouched));
        }
      }
    }
  }
}

TEST(Levels, RecordingChangesNothingOfTheRun)
{
  for (const Mode mode : AllModes())
  {
    const Options options = InMode(mode, Reduction(0.9));
    EXPECT_TRUE(
      SameBytes(Record(SmallBone(), options).Run.Surface, Decimate(SmallBone(), options).Surface));
  }
}

TEST(Levels, EveryLevelIsWhatTheEditsDoOneByOne)
{
  const Surface bone = LargeBone();
  const Recorded recorded = Record(bone, InMode(Mode::Fast, Reduction(0.95)));
  const Levels& levels = recorded.Levels;
  OneByOne oracle(bone, levels.Log());
  const Index last = levels.NumberOfCollapses();
  for (const Index level : { 1, 1000, last / 3, last / 2, last - 1000, last })
  {
    EXPECT_EQ(oracle.GoTo(level), 0) << "a run can go in that order";
    EXPECT_TRUE(SameBytes(levels.At(level).Surface, oracle.Now())) << level;
  }
}

TEST(Levels, LevelsBeforeTheRelaxationAreWhatTheEditsDoOneByOneToo)
{
  const Surface bone = LargeBone();
  const Recorded recorded = Record(bone, InMode(Mode::Balanced, Reduction(0.9)));
  ASSERT_FALSE(recorded.Levels.Log().Patches.empty());
  const Index before = recorded.Levels.Log().Patches.front().Collapses - 1;
  OneByOne oracle(bone, recorded.Levels.Log());
  EXPECT_EQ(oracle.GoTo(before), 0);
  EXPECT_TRUE(SameBytes(recorded.Levels.At(before).Surface, oracle.Now()));
}

TEST(Levels, ThesisAndSmallFastRunsWithACountEndOnItsLevel)
{
  for (const Mode mode : { Mode::Thesis, Mode::Fast })
  {
    for (const Surface& bone : { SmallBone(), HeightField(40, 0.3, 7) })
    {
      const Recorded recorded = Record(bone, InMode(mode, Triangles(60)));
      for (const int count : { 3000, 2000, 1001, 300, 100, 60 })
      {
        const Index level = recorded.Levels.ByTriangles(count);
        EXPECT_TRUE(SameBytes(recorded.Levels.At(level).Surface,
          Decimate(bone, InMode(mode, Triangles(count))).Surface))
          << WordOf(mode) << " to " << count;
      }
    }
  }
}

TEST(Levels, TheLevelOfACountIsTheFirstWithNoMore)
{
  const Recorded recorded = Record(HeightField(30, 0.3, 7), InMode(Mode::Fast, Triangles(100)));
  const Levels& levels = recorded.Levels;
  for (const Index count : { 1799, 1500, 777, 100 })
  {
    const Index level = levels.ByTriangles(count);
    EXPECT_LE(levels.TrianglesAt(level), count);
    EXPECT_GT(levels.TrianglesAt(level - 1), count);
    EXPECT_EQ(
      static_cast<Index>(levels.At(level).Surface.Triangles.size()), levels.TrianglesAt(level));
  }
  EXPECT_EQ(levels.ByTriangles(1800), 0);
  EXPECT_EQ(levels.ByTriangles(0), levels.NumberOfCollapses()) << "there is none so small";
}

TEST(Levels, TheLogIsTheSameForAnyNumberOfThreads)
{
  const Surface bone = LargeBone();
  Options options = Reduction(0.8);
  const std::vector<unsigned char> expected = WriteLog(Record(bone, options).Levels.Log());
  for (const int threads : { 2, 4, 8 })
  {
    options.NumberOfThreads = threads;
    EXPECT_EQ(WriteLog(Record(bone, options).Levels.Log()), expected) << threads << " threads";
  }
}

TEST(Levels, WithALargestErrorEveryLevelKeepsIt)
{
  const Surface bone = BumpySphere(3, 20.0, 0.02, 31);
  const Recorded recorded = Record(bone, Error(0.2));
  const Levels& levels = recorded.Levels;
  const Index last = levels.NumberOfCollapses();
  EXPECT_TRUE(SameBytes(levels.At(last).Surface, recorded.Run.Surface));
  for (const Index level : { last / 4, last / 2, last })
  {
    const Surface surface = levels.At(level).Surface;
    EXPECT_LE(MaxDistance(bone, surface), 0.2);
    EXPECT_LE(MaxDistance(surface, bone), 0.2);
  }
}

TEST(Levels, TheLevelOfAnErrorIsNoFartherFromTheInput)
{
  const Surface bone = SmallBone();
  Options options = Triangles(200);
  options.MeasureDistances = true;
  const Levels levels = Record(bone, options).Levels;
  ASSERT_GT(levels.Log().Marks.size(), 5U);
  for (const double error : { 0.1, 0.3, 0.6, 1.2 })
  {
    const Index level = levels.ByError(error);
    const Surface surface = levels.At(level).Surface;
    EXPECT_LE(MaxDistance(bone, surface), error);
    EXPECT_LE(MaxDistance(surface, bone), error);
  }
  EXPECT_EQ(levels.ByError(0.0), 0);
  EXPECT_EQ(levels.ByError(1000.0), levels.NumberOfCollapses());
  EXPECT_LT(levels.ByError(0.3), levels.ByError(1.2));
}

TEST(Levels, WithoutMeasuredMarksTheLevelOfAnErrorIsTheInput)
{
  const Levels levels = Record(SmallBone(), Triangles(200)).Levels;
  EXPECT_GT(levels.Log().Marks.size(), 5U);
  EXPECT_EQ(levels.ByError(1000.0), 0);
}

TEST(Levels, ARejectedInputHasNone)
{
  Surface broken = SmallBone();
  broken.Points[3][0] = std::nan("");
  EXPECT_FALSE(Record(broken, Triangles(200)).Levels.IsOpen());
  EXPECT_FALSE(Record(Surface(), Triangles(200)).Levels.IsOpen());
}

TEST(Levels, OnTheSameSurfaceMovedTurnedAndScaledTheyMoveTurnAndGrowWithIt)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, Triangles(300));
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(2.1, Vector3(1.0, -2.0, 0.5).normalized()));
  const auto map = [&](const Vector3& p)
  { return Vector3(1.7 * (turn * p) + Vector3(30.0, -4.0, 11.0)); };
  for (const int count : { 3000, 1000, 300 })
  {
    const Index level = recorded.Levels.ByTriangles(count);
    const Surface expected = Mapped(recorded.Levels.At(level).Surface, map);
    const std::optional<Level> there = recorded.Levels.AtOn(Mapped(bone, map), level);
    ASSERT_TRUE(there.has_value());
    EXPECT_EQ(there->Surface.Triangles, expected.Triangles);
    EXPECT_LT(LargestMove(there->Surface, expected), 1e-10);
  }
}

TEST(Levels, OnABentBoneTheyStayAsNearToItAsOnTheRecordedOne)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, Triangles(500));
  const Surface bent = Mapped(bone,
    [](const Vector3& p)
    { return Vector3(1.2 * p[0] + 0.01 * p[1] * p[1], p[1] + 3.0, 0.9 * p[2] + 0.1 * p[0]); });
  const Index last = recorded.Levels.NumberOfCollapses();
  const std::optional<Level> there = recorded.Levels.AtOn(bent, last);
  ASSERT_TRUE(there.has_value());
  EXPECT_LT(
    MaxDistance(there->Surface, bent), 2.0 * MaxDistance(recorded.Levels.At(last).Surface, bone));
  EXPECT_LT(
    MaxDistance(bent, there->Surface), 2.0 * MaxDistance(bone, recorded.Levels.At(last).Surface));
}

TEST(Levels, UnmovedPointsAreThoseOfTheOtherSurfaceBitForBit)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, Triangles(300));
  const Surface other = Mapped(bone, [](const Vector3& p) { return Vector3(1.1 * p); });
  EXPECT_TRUE(SameInAnyOrder(recorded.Levels.AtOn(other, 0)->Surface, other));
}

TEST(Levels, RejectsOtherTriangles)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, Triangles(300));
  Surface other = bone;
  std::swap(other.Triangles[5], other.Triangles[6]);
  EXPECT_FALSE(recorded.Levels.AtOn(other, 10).has_value());
  other = bone;
  other.Points.pop_back();
  EXPECT_FALSE(recorded.Levels.AtOn(other, 10).has_value());
}

TEST(Levels, RejectsUnusablePositions)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, Triangles(300));
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), 1e200 })
  {
    Surface other = bone;
    other.Points[7][2] = bad;
    EXPECT_FALSE(recorded.Levels.AtOn(other, 10).has_value());
  }
}
