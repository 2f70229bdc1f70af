// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Not representable in single precision, far from the origin so that subtracting and adding
/// rounds.
Surface FarBumps()
{
  return Moved(SurfaceOf(Bumps(3)), { 12345.1, -98765.7, 1e6 / 3 });
}

int TypeOfOutput(int inputType, int precision)
{
  FilterRun run(PolyData(Icosphere(2, 10.0), inputType));
  run->SetOutputPointsPrecision(precision);
  return run.Output()->GetPoints()->GetDataType();
}

std::set<std::array<double, 3>> PositionsOf(const Surface& surface)
{
  std::set<std::array<double, 3>> positions;
  for (const Vector3& p : surface.Points)
  {
    positions.insert({ p[0], p[1], p[2] });
  }
  return positions;
}

/// How many points that represent one input point are not, bit for bit, among its positions; none
/// may be.
int MovedAlone(vtkPolyData* output, const Surface& input)
{
  const std::set<std::array<double, 3>> positions = PositionsOf(input);
  const Surface result = SurfaceOf(output);
  const std::vector<double> counts = Values(output, "InputPointCount");
  int moved = 0;
  int alone = 0;
  for (std::size_t p = 0; p < counts.size(); ++p)
  {
    const Vector3& at = result.Points[p];
    alone += counts[p] == 1.0 ? 1 : 0;
    moved += counts[p] == 1.0 && positions.count({ at[0], at[1], at[2] }) == 0 ? 1 : 0;
  }
  EXPECT_GT(alone, 0) << "the test proves nothing";
  return moved;
}
}

TEST(Precision, SingleAndDoubleDoNotDependOnTheInput)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    EXPECT_EQ(TypeOfOutput(type, vtkAlgorithm::SINGLE_PRECISION), VTK_FLOAT);
    EXPECT_EQ(TypeOfOutput(type, vtkAlgorithm::DOUBLE_PRECISION), VTK_DOUBLE);
  }
}

TEST(Precision, DefaultIsThatOfTheInput)
{
  EXPECT_EQ(TypeOfOutput(VTK_FLOAT, vtkAlgorithm::DEFAULT_PRECISION), VTK_FLOAT);
  EXPECT_EQ(TypeOfOutput(VTK_DOUBLE, vtkAlgorithm::DEFAULT_PRECISION), VTK_DOUBLE);
}

TEST(Precision, IntegerPointsGiveDoubleOnesByDefault)
{
  EXPECT_EQ(TypeOfOutput(VTK_INT, vtkAlgorithm::DEFAULT_PRECISION), VTK_DOUBLE);
}

TEST(Precision, ChangesTheRoundingButNotTheTriangles)
{
  FilterRun exact(PolyData(FarBumps()));
  FilterRun rounded(PolyData(FarBumps()));
  rounded->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  const Surface points = SurfaceOf(exact.Output());
  const Surface singles = SurfaceOf(rounded.Output());
  EXPECT_EQ(points.Triangles, singles.Triangles);
  ASSERT_EQ(points.Points.size(), singles.Points.size());
  for (std::size_t p = 0; p < points.Points.size(); ++p)
  {
    EXPECT_EQ(points.Points[p].cast<float>(), singles.Points[p].cast<float>()) << "point " << p;
  }
}

TEST(Precision, PointsThatNeverMovedKeepTheirCoordinatesBitForBit)
{
  for (const double reduction : { 0.0, 0.3, 0.7 })
  {
    const Surface input = SurfaceOf(Bumps(3)); // subtracting its least corner rounds
    FilterRun run(PolyData(input));
    run->SetModeToFast(); // points move only when they are merged
    run->SetTargetReduction(reduction);
    EXPECT_EQ(MovedAlone(run.Output(), input), 0) << reduction;
  }
}

TEST(Precision, PointsOfSinglePrecisionThatNeverMovedKeepThemToo)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(SurfaceOf(Bumps(3)), VTK_FLOAT);
  FilterRun run(input);
  run->SetModeToFast();
  run->SetTargetReduction(0.3);
  EXPECT_EQ(MovedAlone(run.Output(), SurfaceOf(input)), 0);
}

TEST(Precision, AnOpenBoundaryThatIsStraightStaysStraight)
{
  FilterRun run(PolyData(HeightField(16, 0.5, 9)));
  const Surface output = SurfaceOf(run.Output());
  double least = 1e9;
  double greatest = -1e9;
  for (const Vector3& p : output.Points)
  {
    least = std::min({ least, p[0], p[1] });
    greatest = std::max({ greatest, p[0], p[1] });
  }
  EXPECT_EQ(least, 0.0);
  EXPECT_EQ(greatest, 16.0);
}
