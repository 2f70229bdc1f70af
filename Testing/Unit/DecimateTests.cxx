// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The driver with each option, with invalid inputs, threads and monitors.
#include "BruteForce.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Surface Bone()
{
  return BumpySphere(4, 20.0, 0.02, 31);
}

std::int64_t Faces(const Result& result)
{
  return static_cast<std::int64_t>(result.Surface.Triangles.size());
}

std::int64_t CountBeyond(const std::vector<double>& distances, double limit)
{
  return std::count_if(distances.begin(), distances.end(), [=](double d) { return d > limit; });
}

bool AreFloats(const Surface& surface)
{
  return std::all_of(surface.Points.begin(), surface.Points.end(),
    [](const Vector3& p)
    {
      return std::all_of(p.begin(), p.end(),
        [](double coordinate)
        {
          // gcc 12 at -O3 takes pairs of roundings to float and back for nothing and leaves them
          // out.
          const volatile float single = static_cast<float>(coordinate);
          return static_cast<double>(single) == coordinate;
        });
    });
}
}

TEST(Decimate, DefaultRemovesNineTenths)
{
  const Result result = Decimate(Bone(), Unmeasured());
  EXPECT_EQ(Faces(result), 512);
  EXPECT_EQ(result.Report.Stop, StopReason::TargetReached);
}

TEST(Decimate, ReductionIsTheFractionRemoved)
{
  EXPECT_EQ(Faces(Decimate(Bone(), Reduction(0.25))), 3840);
  EXPECT_EQ(Faces(Decimate(Bone(), Reduction(0.75))), 1280);
}

TEST(Decimate, ReductionZeroReturnsTheInputBitForBit)
{
  const Surface input = Bone();
  Options options = Reduction(0.0);
  options.MeasureDistances = true;
  const Result result = Decimate(input, options);
  EXPECT_TRUE(SameInAnyOrder(result.Surface, input));
  EXPECT_EQ(result.Report.Stop, StopReason::AlreadySatisfied);
  EXPECT_EQ(result.Report.RunningError, 0.0);
}

TEST(Decimate, NumberOfTrianglesIsReached)
{
  const Result result = Decimate(Bone(), Triangles(1000));
  EXPECT_EQ(Faces(result), 1000);
  EXPECT_EQ(Faces(Decimate(Bone(), Triangles(1001))), 1000)
    << "closed surfaces have an even number";
  EXPECT_EQ(result.Report.Stop, StopReason::TargetReached);
}

TEST(Decimate, ANumberAboveTheInputLeavesItAsItIs)
{
  const Result result = Decimate(Bone(), Triangles(1000000));
  EXPECT_TRUE(SameInAnyOrder(result.Surface, Bone()));
  EXPECT_EQ(result.Report.Stop, StopReason::AlreadySatisfied);
}

TEST(Decimate, TheDefaultReductionIsIgnoredWithANumberOrAnError)
{
  EXPECT_EQ(Faces(Decimate(Bone(), Triangles(100))), 100) << "a tenth would be 512";
  EXPECT_EQ(Faces(Decimate(Bone(), Triangles(4000))), 4000);
  EXPECT_GT(Faces(Decimate(Bone(), Error(1e-4))), 4000);
}

TEST(Decimate, OfNumberAndExplicitReductionTheFirstReachedStops)
{
  Options options = Reduction(0.5);
  options.TargetNumberOfTriangles = 4000;
  EXPECT_EQ(Faces(Decimate(Bone(), options)), 4000);
  options.TargetNumberOfTriangles = 1000;
  EXPECT_EQ(Faces(Decimate(Bone(), options)), 2560);
}

TEST(Decimate, AnExplicitReductionOfOneIsOff)
{
  Options options = Reduction(1.0);
  options.TargetNumberOfTriangles = 3000;
  EXPECT_EQ(Faces(Decimate(Bone(), options)), 3000);
  EXPECT_EQ(Decimate(Bone(), Reduction(1.0)).Report.Stop, StopReason::NothingLeft)
    << "no stop was requested";
}

TEST(Decimate, ALargerErrorLeavesFewerTriangles)
{
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  for (const double error : { 0.01, 0.1, 0.5, 1.0, 3.0 })
  {
    const Result result = Decimate(Bone(), Error(error));
    EXPECT_LT(Faces(result), before) << error;
    EXPECT_EQ(result.Report.Stop, StopReason::ErrorReached) << error;
    before = Faces(result);
  }
}

TEST(Decimate, InThesisAtMostOnePointLiesBeyondTheLargestError)
{
  for (const NamedSurface& shape : AllShapes())
  {
    for (const double error : { 0.01, 0.2, 1.0 })
    {
      Options options = InMode(Mode::Thesis, Error(error));
      options.AllowLargeError = true; // some shapes have a size of 1 mm
      const Result result = Decimate(shape.Surface, options);
      EXPECT_LE(CountBeyond(result.Distance, error), 1) << shape.Name << " at " << error;
      if (result.Report.Stop == StopReason::ErrorReached)
      {
        EXPECT_GE(result.Report.RunningError, error) << shape.Name;
      }
      else
      {
        EXPECT_EQ(result.Report.Stop, StopReason::NothingLeft) << shape.Name;
        EXPECT_LT(result.Report.RunningError, error) << shape.Name;
      }
    }
  }
}

TEST(Decimate, WithNumberAndErrorTheThesisGoesOnUntilBothAreReached)
{
  Options options = InMode(Mode::Thesis, Error(0.5));
  const std::int64_t byError = Faces(Decimate(Bone(), options));
  options.TargetNumberOfTriangles = static_cast<int>(byError) + 1000;
  EXPECT_EQ(Faces(Decimate(Bone(), options)), byError)
    << "below the number as long as the error allows";
  options.TargetNumberOfTriangles = static_cast<int>(byError) - 200;
  const Result further = Decimate(Bone(), options);
  EXPECT_EQ(Faces(further), byError - 200) << "beyond the error until the number is reached";
  EXPECT_GE(further.Report.RunningError, 0.5);
}

TEST(Decimate, NormalToleranceOneCollapsesFlatAreasFirstAndZeroDoesNot)
{
  // Left half flat, right half rough.
  Surface plate = HeightField(24, 0.4, 6);
  for (Vector3& p : plate.Points)
  {
    p.z() = p.x() < 12.0 ? 0.0 : p.z();
  }
  const auto leftOnes = [&](double tolerance)
  {
    Options options = InMode(Mode::Thesis, Reduction(0.45));
    options.NormalTolerance = tolerance;
    const Result result = Decimate(plate, options);
    return std::count_if(result.Surface.Points.begin(), result.Surface.Points.end(),
      [](const Vector3& p) { return p.x() < 11.5; });
  };
  EXPECT_LT(2 * leftOnes(1.0), leftOnes(0.5));
  EXPECT_LT(2 * leftOnes(1.0), leftOnes(0.0));
}

TEST(Decimate, ChoosesTheNormalToleranceByTheRemainingFraction)
{
  const Surface bone = BumpySphere(4, 20.0, 0.02, 3);
  const auto run = [&](Options options)
  {
    options.AutomaticNormalTolerance = true;
    return Decimate(bone, InMode(Mode::Thesis, options));
  };
  EXPECT_EQ(run(Reduction(0.4)).Report.NormalTolerance, 0.95);
  EXPECT_NEAR(run(Reduction(0.7)).Report.NormalTolerance, 0.7125, 1e-9);
  EXPECT_EQ(run(Triangles(100)).Report.NormalTolerance, 0.0);
  EXPECT_EQ(run(Error(0.05)).Report.NormalTolerance, 0.95) << "the remaining number is unknown";
  Options chosen = InMode(Mode::Thesis, Reduction(0.7));
  chosen.NormalTolerance = run(Reduction(0.7)).Report.NormalTolerance;
  EXPECT_TRUE(SameBytes(Decimate(bone, chosen).Surface, run(Reduction(0.7)).Surface));
}

TEST(Decimate, WithoutMergingASoupStaysASoup)
{
  const Surface soup = Unwelded(Icosphere(2, 5.0));
  Options options = Reduction(0.5);
  EXPECT_EQ(Faces(Decimate(soup, options)), 160);
  EXPECT_EQ(Decimate(soup, options).Report.Cleaning.MergedPoints, 960 - 162);
  options.MergePoints = false;
  const Result apart = Decimate(soup, options);
  EXPECT_TRUE(SameInAnyOrder(apart.Surface, soup));
  EXPECT_EQ(apart.Report.Stop, StopReason::NothingLeft);
  EXPECT_EQ(apart.Report.Input.Components, 320);
  EXPECT_EQ(apart.Report.Cleaning.MergedPoints, 0);
}

TEST(Decimate, MeasuresDistancesOnRequest)
{
  const Surface input = BumpySphere(3, 20.0, 0.05, 2);
  Options options = Reduction(0.8);
  options.MeasureDistances = true;
  const Result result = Decimate(input, options);
  ASSERT_TRUE(result.Report.DistancesMeasured);
  EXPECT_EQ(result.Report.OutputToInput.PointMaximum,
    *std::max_element(result.Distance.begin(), result.Distance.end()));
  double greatest = 0.0;
  for (const Vector3& p : input.Points)
  {
    greatest = std::max(greatest, BruteNearest(result.Surface, p).Distance);
  }
  EXPECT_NEAR(result.Report.InputToOutput.PointMaximum, greatest, 1e-12);
  for (const DistanceStatistics& side :
    { result.Report.OutputToInput, result.Report.InputToOutput })
  {
    EXPECT_GT(side.Samples, 0);
    EXPECT_GE(side.Maximum, side.PointMaximum);
    EXPECT_GE(side.PointMaximum, side.Second);
    EXPECT_GE(side.RootMeanSquare, side.Mean);
    EXPECT_GT(side.Mean, 0.0);
  }
  EXPECT_FALSE(Decimate(input, Reduction(0.8)).Report.DistancesMeasured);
}

TEST(Decimate, InputDistancesVsBruteForceAndOnlyOnRequest)
{
  Surface input = BumpySphere(2, 20.0, 0.05, 2);
  input.Points.emplace_back(1.0, 2.0, 3.0); // used by no triangle
  Options options = Reduction(0.8);
  EXPECT_TRUE(Decimate(input, options).InputDistance.empty());
  options.MeasureInputDistances = true;
  const Result result = Decimate(input, options);
  ASSERT_EQ(result.InputDistance.size(), input.Points.size());
  for (std::size_t i = 0; i < input.Points.size(); ++i)
  {
    EXPECT_NEAR(
      result.InputDistance[i], BruteNearest(result.Surface, input.Points[i]).Distance, 1e-12);
  }
}

TEST(Decimate, PrecisionIsTheRequestedOneOrThatOfTheInput)
{
  const auto isSingle = [](PointsPrecision precision, bool inputIsSingle)
  {
    Options options = Reduction(0.5);
    options.OutputPointsPrecision = precision;
    return AreFloats(Decimate(Bone(), options, {}, { inputIsSingle }).Surface);
  };
  EXPECT_TRUE(isSingle(PointsPrecision::Single, false));
  EXPECT_FALSE(isSingle(PointsPrecision::Double, true));
  EXPECT_TRUE(isSingle(PointsPrecision::Default, true));
  EXPECT_FALSE(isSingle(PointsPrecision::Default, false));
}

TEST(Decimate, DistancesOfSinglePrecisionPointsAreThoseOfTheRoundedOnes)
{
  const Surface input = Moved(Bone(), { 1000, 0, 0 });
  Options options = Reduction(0.5);
  options.OutputPointsPrecision = PointsPrecision::Single;
  const Result result = Decimate(input, options);
  for (std::size_t i = 0; i < result.Distance.size(); i += 7)
  {
    EXPECT_NEAR(result.Distance[i], BruteNearest(input, result.Surface.Points[i]).Distance, 1e-9);
  }
}

TEST(Decimate, LooksPointsUpOnlyOnRequest)
{
  Options options = InMode(Mode::Thesis, Reduction(0.5));
  const Result thesis = Decimate(Bone(), options);
  EXPECT_EQ(thesis.Distance.size(), thesis.Surface.Points.size()) << "recorded on the way";
  EXPECT_TRUE(thesis.Origins.NearestTriangle.empty());
  options.Mode = Mode::Fast;
  const Result plain = Decimate(Bone(), options);
  EXPECT_TRUE(plain.Distance.empty());
  EXPECT_TRUE(plain.RunningError.empty());
  EXPECT_TRUE(std::isnan(plain.Report.RunningError)) << "unknown is not nothing";
  EXPECT_EQ(plain.PointCount.size(), plain.Surface.Points.size());
  const Result mapped = Decimate(Bone(), options, {}, { false, true });
  EXPECT_EQ(mapped.Origins.Barycentric.size(), mapped.Surface.Points.size());
  EXPECT_EQ(mapped.RunningError, mapped.Distance);
  options.MeasureDistances = true;
  const Result measured = Decimate(Bone(), options);
  EXPECT_EQ(measured.Distance, mapped.Distance);
  EXPECT_EQ(measured.Report.RunningError, mapped.Report.RunningError);
  EXPECT_TRUE(measured.Origins.NearestPoint.empty());
  EXPECT_TRUE(SameBytes(plain.Surface, measured.Surface));
}

TEST(Decimate, TheSameBytesWhateverTheThreads)
{
  Options options = Reduction(0.7);
  options.MeasureInputDistances = true;
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  options.NumberOfThreads = 1;
  const Result one = Decimate(input, options, {}, { false, true });
  for (const int threads : { 1, 2, 4, 8, 0 })
  {
    options.NumberOfThreads = threads;
    const Result many = Decimate(input, options, {}, { false, true });
    EXPECT_TRUE(SameBytes(one.Surface, many.Surface)) << threads;
    EXPECT_EQ(one.Distance, many.Distance) << threads;
    EXPECT_EQ(one.InputDistance, many.InputDistance) << threads;
    EXPECT_EQ(one.Origins.Barycentric, many.Origins.Barycentric) << threads;
  }
}

TEST(Decimate, TheSameDistancesWhateverTheThreads)
{
  Options options = Reduction(0.7);
  options.MeasureDistances = true;
  const Surface input = BumpySphere(2, 20.0, 0.1, 5);
  options.NumberOfThreads = 1;
  const Report one = Decimate(input, options).Report;
  options.NumberOfThreads = 4;
  const Report many = Decimate(input, options).Report;
  EXPECT_EQ(one.OutputToInput.Mean, many.OutputToInput.Mean);
  EXPECT_EQ(one.InputToOutput.RootMeanSquare, many.InputToOutput.RootMeanSquare);
  EXPECT_EQ(one.InputToOutput.Maximum, many.InputToOutput.Maximum);
}

TEST(Decimate, ASecondRunGivesTheSameBytes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    EXPECT_TRUE(SameBytes(Decimate(shape.Surface, Reduction(0.6)).Surface,
      Decimate(shape.Surface, Reduction(0.6)).Surface))
      << shape.Name;
  }
}

TEST(Decimate, SharpEdgesStayWhileFlatAreasCostNothing)
{
  for (const Surface& input : { Cube(8), FlatPlate(12), TunnelBlock(9) })
  {
    Options options = InMode(Mode::Thesis, Reduction(0.6));
    options.NormalTolerance = 1.0;
    const Result result = Decimate(input, options);
    EXPECT_LT(result.Report.RunningError, 0.25) << "a quarter of the plate's thickness";
    EXPECT_NEAR(SignedVolume(result.Surface), SignedVolume(input), 0.05 * SignedVolume(input));
  }
}

TEST(Decimate, FlatOpenSurfacesKeepTheirBoundaryAndTheirArea)
{
  for (const Surface& input : { Grid(12), HoledPlate(12) })
  {
    for (const double fraction : { 0.3, 0.5, 0.8 })
    {
      const Result result = Decimate(input, Reduction(fraction));
      EXPECT_NEAR(TotalArea(result.Surface), TotalArea(input), 1e-9) << fraction;
      for (const double distance : result.Distance)
      {
        EXPECT_LT(distance, 1e-12);
      }
    }
  }
}

TEST(Decimate, StraightBoundariesOfRoughSurfacesStayStraight)
{
  const Surface input = HeightField(16, 0.5, 9);
  const std::vector<std::pair<Index, Index>> boundary = BoundaryEdges(input);
  for (const double fraction : { 0.2, 0.4, 0.6 })
  {
    const Result result = Decimate(input, Reduction(fraction));
    for (const auto& [from, to] : BoundaryEdges(result.Surface))
    {
      double nearest = std::numeric_limits<double>::max();
      const Vector3& p = result.Surface.Points[from];
      for (const auto& [a, b] : boundary)
      {
        nearest = std::min(
          nearest, PointTriangleDistance(p, input.Points[a], input.Points[b], input.Points[a]));
      }
      EXPECT_LT(nearest, 1e-9) << "boundary point " << from << " to " << to << " at " << fraction;
    }
  }
}
