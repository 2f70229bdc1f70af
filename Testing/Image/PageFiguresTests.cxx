// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a page counts and lists: where surfaces are farthest apart, specks, labels, numbers.
#include "FarthestPoints.h"
#include "NumberText.h"
#include "SurfaceExtents.h"

#include "vtkAppendPolyData.h"
#include "vtkBoneDecimate.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
using namespace bonedecimate;

constexpr double Radius = 30.0; // mm

vtkSmartPointer<vtkPolyData> Ball(double radius, double x, int resolution = 40)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetCenter(x, 0.0, 0.0);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  ball->Update();
  return ball->GetOutput();
}

/// A ball whose points have distances of a wave over its surface.
vtkSmartPointer<vtkPolyData> BallWithDistances(double phase)
{
  auto ball = vtkSmartPointer<vtkPolyData>::New();
  ball->DeepCopy(Ball(Radius, 0.0));
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("Distance");
  for (vtkIdType point = 0; point < ball->GetNumberOfPoints(); ++point)
  {
    const double* const p = ball->GetPoint(point);
    distances->InsertNextValue(
      std::abs(std::sin(0.2 * p[0] + phase) * std::cos(0.13 * p[1]) + 0.01 * p[2]));
  }
  ball->GetPointData()->AddArray(distances);
  return ball;
}

double Apart(const double* a, const std::array<double, 3>& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b.data()));
}

TEST(FarthestPoints, AreTheLargestDistancesThatAreApart)
{
  const auto original = BallWithDistances(0.3);
  const auto result = BallWithDistances(1.1);
  const std::vector<FarPoint> points =
    FindFarthestPoints({ original, "Distance" }, { result, "Distance" });
  ASSERT_EQ(points.size(), 10U);
  const double separation = 0.05 * original->GetLength();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_TRUE(i == 0 || points[i].Distance <= points[i - 1].Distance) << i;
    for (std::size_t k = 0; k < i; ++k)
    {
      EXPECT_GE(Apart(points[i].Position.data(), points[k].Position), separation * (1.0 - 1e-9));
    }
    const std::array<double, 3>& p = points[i].Position; // its normal leads away from the center
    const double along = vtkMath::Dot(p.data(), points[i].Outward.data()) / Radius;
    EXPECT_NEAR(along, 1.0, 0.01);
  }
  for (const auto& surface : { original, result })
  {
    for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
    {
      const double distance = surface->GetPointData()->GetArray("Distance")->GetComponent(point, 0);
      const bool isListed = distance <= points.back().Distance ||
        std::any_of(points.begin(), points.end(),
          [&](const FarPoint& one)
          {
            return one.Distance >= distance &&
              Apart(surface->GetPoint(point), one.Position) <= separation * (1.0 + 1e-9);
          });
      EXPECT_TRUE(isListed) << point;
    }
  }
}

TEST(FarthestPoints, AreNoneWithoutDistances)
{
  EXPECT_TRUE(FindFarthestPoints({ Ball(5.0, 0.0), "Distance" }, { Ball(5.0, 0.0), "" }).empty());
}

TEST(FarthestPoints, AreNamedAlongTheAxesOfThePatient)
{
  const std::array<double, 3> position = { -12.34, 5.0, -1000.0 };
  EXPECT_EQ(AnatomicalText(position, "LPS"), "R 12.3, P 5.0, I 1,000.0");
  EXPECT_EQ(AnatomicalText(position, "RAS"), "L 12.3, A 5.0, I 1,000.0");
  EXPECT_EQ(AnatomicalText(position, ""), "-12.3, 5.0, -1,000.0");
}

/// The run that leaves specks out is the oracle.
TEST(Specks, AreWhatPruningOfTheirSizeLeavesOut)
{
  vtkNew<vtkAppendPolyData> all;
  all->AddInputData(Ball(Radius, 0.0));
  double area = 4.0 * Radius * Radius;
  for (int i = 1; i <= 12; ++i)
  {
    all->AddInputData(Ball(0.15 * i, 40.0 + 8.0 * i, 20)); // up to 3.6 mm across
    area += 4.0 * 0.15 * i * 0.15 * i;
  }
  all->Update();
  const SpeckFigures specks = FindSpecks(all->GetOutput());
  EXPECT_EQ(specks.Components, 13);
  EXPECT_EQ(specks.Size, 3.0); // the box is 167.8 x 60 x 60 mm, a fiftieth of its diagonal 3.76
  vtkNew<vtkBoneDecimate> filter;
  filter->SetInputConnection(all->GetOutputPort());
  filter->SetTargetReduction(0.0);
  filter->SetPruneSize(specks.Size);
  filter->Update();
  EXPECT_EQ(filter->GetReportValue("pruned.components"), static_cast<double>(specks.Specks));
  EXPECT_GT(specks.Specks, 5);
  double pruned = 0.0;
  for (int i = 0; i < specks.Specks; ++i)
  {
    pruned += filter->GetReportValue("pruned.list." + std::to_string(i) + ".area");
  }
  EXPECT_NEAR(specks.AreaRatio, pruned / (pruned + filter->GetReportValue("input.area")), 1e-12);
  EXPECT_EQ(FindSpecks(filter->GetOutput(0)).Specks, 0);
}

/// Two boxes with a wall in common, x from 0 over 2 to 5 mm; 1 is on the left, 2 on the right.
vtkSmartPointer<vtkPolyData> TwoBoxes()
{
  vtkNew<vtkAppendPolyData> both;
  vtkNew<vtkIntArray> sides;
  sides->SetName("BoundaryLabels");
  sides->SetNumberOfComponents(2);
  for (const double left : { 0.0, 2.0 })
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(left, left == 0.0 ? 2.0 : 5.0, 0.0, 1.0, 0.0, 1.0);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(box->GetOutputPort());
    triangles->Update();
    vtkNew<vtkPolyData> part;
    part->DeepCopy(triangles->GetOutput());
    part->GetPointData()->Initialize();
    for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
    {
      double bounds[6];
      part->GetCellBounds(cell, bounds);
      const bool isWall = bounds[0] == 2.0 && bounds[1] == 2.0;
      if (isWall && left == 2.0)
      {
        part->DeleteCell(cell); // it is there already, seen from the left
        continue;
      }
      const int wall[2] = { 1, 2 };
      const int outside[2] = { left == 0.0 ? 1 : 2, 0 };
      sides->InsertNextTypedTuple(isWall ? wall : outside);
    }
    part->RemoveDeletedCells();
    both->AddInputData(part);
  }
  both->Update();
  both->GetOutput()->GetCellData()->AddArray(sides);
  return both->GetOutput();
}

TEST(LabelExtents, CountAWallForBothOfItsLabels)
{
  const std::vector<NamedLabel> labels = { { 1, "left", {} }, { 2, "", {} }, { 3, "none", {} } };
  const std::vector<LabelExtent> extents = LabelExtents(TwoBoxes(), labels);
  ASSERT_EQ(extents.size(), 3U);
  EXPECT_NEAR(extents[0].Volume, 2.0, 1e-12);
  EXPECT_NEAR(extents[1].Volume, 3.0, 1e-12);
  EXPECT_NEAR(extents[0].Area, 2.0 + 4.0 * 2.0, 1e-12);
  EXPECT_NEAR(extents[1].Area, 2.0 + 4.0 * 3.0, 1e-12);
  EXPECT_EQ(extents[0].Triangles + extents[1].Triangles, 24); // 22 of the surface
  EXPECT_EQ(extents[0].Components, 1);
  EXPECT_EQ(extents[2].Triangles, 0);
  EXPECT_EQ(extents[2].Components, 0);
  EXPECT_TRUE(LabelExtents(Ball(5.0, 0.0), labels).empty());
}

TEST(NumberText, SetsThousandsApart)
{
  EXPECT_EQ(GroupedText(0), "0");
  EXPECT_EQ(GroupedText(999), "999");
  EXPECT_EQ(GroupedText(1000), "1,000");
  EXPECT_EQ(GroupedText(-1234567), "-1,234,567");
  EXPECT_EQ(GroupedText(666264.25, 1), "666,264.2");
}

TEST(NumberText, NeverTurnsADistanceIntoNone)
{
  EXPECT_EQ(MillimeterText(0.0), "0.000");
  EXPECT_EQ(MillimeterText(1e-9), "< 0.001");
  EXPECT_EQ(MillimeterText(0.0005), "0.001");
  EXPECT_EQ(MillimeterText(1.2345), "1.234");
}

TEST(NumberText, NeverShowsAMeasuredDistanceAboveItsBound)
{
  EXPECT_EQ(MeasuredText(0.49996), "0.4999");
  EXPECT_EQ(BoundText(0.49991), "0.5000");
  EXPECT_EQ(MeasuredText(0.5), "0.5000");
  EXPECT_EQ(BoundText(0.5), "0.5000");
  EXPECT_EQ(MeasuredText(0.0), "0.0000");
  EXPECT_EQ(MeasuredText(1e-9), "< 0.0001");
  EXPECT_EQ(BoundText(1e-9), "0.0001");
  for (int i = 1; i < 20000; ++i)
  {
    const double distance = 1.00001 * i / 20000.0;
    EXPECT_LE(std::strtod(MeasuredText(distance).c_str(), nullptr),
      std::strtod(BoundText(distance).c_str(), nullptr))
      << distance;
  }
}

TEST(NumberText, RoundsUpToReadableNumbers)
{
  EXPECT_DOUBLE_EQ(RoundUp(0.3, { 1.0, 3.0, 5.0 }), 0.3);
  EXPECT_DOUBLE_EQ(RoundUp(0.301, { 1.0, 3.0, 5.0 }), 0.5);
  EXPECT_DOUBLE_EQ(RoundUp(0.00081, { 1.0, 3.0, 5.0 }), 0.001);
  EXPECT_DOUBLE_EQ(RoundUp(1.0, { 1.0, 3.0, 5.0 }), 1.0);
  EXPECT_DOUBLE_EQ(RoundUp(85.0, { 1.0, 3.0, 5.0 }), 100.0);
}
}
