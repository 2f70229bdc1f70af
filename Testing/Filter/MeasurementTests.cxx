// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The middles of the perTriangle^2 equal parts of every triangle, triangle after triangle.
std::vector<Vector3> Spread(const Surface& surface, int perTriangle)
{
  std::vector<Vector3> points;
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3& a = surface.Points[static_cast<std::size_t>(c[0])];
    const Vector3 u = (surface.Points[static_cast<std::size_t>(c[1])] - a) / perTriangle;
    const Vector3 v = (surface.Points[static_cast<std::size_t>(c[2])] - a) / perTriangle;
    for (int i = 0; i < perTriangle; ++i)
    {
      for (int j = 0; i + j < perTriangle; ++j)
      {
        points.push_back(a + (i + 1.0 / 3) * u + (j + 1.0 / 3) * v);
        if (i + j + 1 < perTriangle)
        {
          points.push_back(a + (i + 2.0 / 3) * u + (j + 2.0 / 3) * v);
        }
      }
    }
  }
  return points;
}

struct Measured
{
  double Maximum = 0.0; // mm
  double Mean = 0.0;
  double RootMeanSquare = 0.0;
};

/// Over the area of one surface to the other, by vtkCellLocator.
Measured MeasureWithVtk(vtkPolyData* from, vtkPolyData* to)
{
  constexpr int PerTriangle = 8;
  const Surface surface = SurfaceOf(from);
  const std::vector<double> distances = LocatorDistances(Spread(surface, PerTriangle), to);
  Measured measured;
  double area = 0.0;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const Triangle& c = surface.Triangles[i / (PerTriangle * PerTriangle)];
    const auto point = [&](int k)
    { return surface.Points[static_cast<std::size_t>(c[static_cast<std::size_t>(k)])]; };
    const double weight = (point(1) - point(0)).cross(point(2) - point(0)).norm();
    measured.Maximum = std::max(measured.Maximum, distances[i]);
    measured.Mean += weight * distances[i];
    measured.RootMeanSquare += weight * distances[i] * distances[i];
    area += weight;
  }
  measured.Mean /= area;
  measured.RootMeanSquare = std::sqrt(measured.RootMeanSquare / area);
  return measured;
}

void ExpectReported(FilterRun& run, const std::string& direction, const Measured& measured)
{
  const std::string path = "distance." + direction;
  EXPECT_NEAR(run.Value(path + ".mean"), measured.Mean, 0.03 * measured.Mean) << path;
  EXPECT_NEAR(run.Value(path + ".rms"), measured.RootMeanSquare, 0.03 * measured.RootMeanSquare)
    << path;
  EXPECT_GE(run.Value(path + ".max") * 1.03, measured.Maximum) << path;
}

void ExpectPointStatistics(FilterRun& run, const std::string& path, std::vector<double> distances)
{
  std::sort(distances.begin(), distances.end());
  const auto count = static_cast<double>(distances.size());
  double squares = 0.0;
  for (const double distance : distances)
  {
    squares += distance * distance;
  }
  EXPECT_NEAR(run.Value(path + ".point_max"), distances.back(), 1e-9);
  EXPECT_NEAR(run.Value(path + ".second"), distances[distances.size() - 2], 1e-9);
  EXPECT_NEAR(run.Value(path + ".point_mean"), Sum(distances) / count, 1e-9);
  EXPECT_NEAR(run.Value(path + ".point_rms"), std::sqrt(squares / count), 1e-9);
  EXPECT_GE(run.Value(path + ".max"), distances.back());
}
}

TEST(Measurement, OverTheAreaAgreesWithTheLocatorInBothDirections)
{
  for (const vtkSmartPointer<vtkPolyData>& input : { Bumps(3), PolyData(HeightField(24, 1.0, 5)) })
  {
    FilterRun run(input);
    run->MeasureDistancesOn();
    run->MeasureDistancesOn();
    vtkPolyData* output = run.Output();
    ExpectReported(run, "output_to_input", MeasureWithVtk(output, input));
    ExpectReported(run, "input_to_output", MeasureWithVtk(input, output));
  }
}

TEST(Measurement, ThePositionOfTheLargestDistanceHasThatDistance)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(HeightField(24, 1.0, 5));
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const double* const p = input->GetPoint(i);
    input->GetPoints()->SetPoint(i, p[0] + 100.0, p[1] - 200.0, p[2] + 300.0);
  }
  FilterRun run(input);
  run->MeasureDistancesOn();
  vtkPolyData* output = run.Output();
  for (const auto& [direction, from, to] : { std::tuple("output_to_input", output, input.Get()),
         std::tuple("input_to_output", input.Get(), output) })
  {
    const std::string path = std::string("distance.") + direction + ".max";
    const Vector3 at = { run.Value(path + "_at.0"), run.Value(path + "_at.1"),
      run.Value(path + "_at.2") };
    EXPECT_NEAR(LocatorDistances({ at }, to)[0], run.Value(path), 1e-5) << direction;
    EXPECT_NEAR(LocatorDistances({ at }, from)[0], 0.0, 1e-5) << direction;
  }
}

TEST(Measurement, OverThePointsAgreesWithTheArraysInBothDirections)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  run->MeasureInputDistancesOn();
  ExpectPointStatistics(run, "distance.output_to_input", Values(run.Output(), "Distance"));
  ExpectPointStatistics(
    run, "distance.input_to_output", Values(run.InputCopy(), "DistanceToResult"));
}

TEST(Measurement, StatesHowManySamplesThereAreOnASquareMillimeter)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  for (const std::string direction : { "output_to_input", "input_to_output" })
  {
    const std::string path = "distance." + direction;
    const double area = run.Value(direction == "input_to_output" ? "input.area" : "output.area");
    EXPECT_GT(run.Value(path + ".samples"), 0);
    EXPECT_NEAR(run.Value(path + ".samples_per_mm2"), run.Value(path + ".samples") / area, 1e-6);
  }
}

TEST(Measurement, OfASurfaceThatDidNotChangeIsZero)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  run->SetTargetReduction(0.0);
  run->MeasureInputDistancesOn();
  for (const char* entry : { "output_to_input.max", "input_to_output.max", "output_to_input.rms" })
  {
    EXPECT_NEAR(run.Value(std::string("distance.") + entry), 0.0, 1e-12);
  }
  EXPECT_EQ(Largest(Values(run.Output(), "Distance")), 0.0);
  EXPECT_EQ(Largest(Values(run.InputCopy(), "DistanceToResult")), 0.0);
}

TEST(Measurement, OfOpenBoundariesIsProvedCurveToCurve)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(HeightField(24, 1.0, 5));
  FilterRun run(input);
  run->MeasureDistancesOn();
  run->SetTargetReduction(0.8);
  vtkNew<vtkBoneSurfaceDistance> comparison;
  comparison->SetInputData(0, input);
  comparison->SetInputData(1, run.Output());
  comparison->Update();
  const auto expectSame = [&](const std::string& reported, const std::string& certified)
  {
    for (const char* bound : { ".lower", ".upper" })
    {
      EXPECT_NEAR(run.Value("distance." + reported + bound),
        comparison->GetReportValue(certified + bound), 1e-9);
    }
    EXPECT_LE(
      run.Value("distance." + reported + ".lower"), run.Value("distance." + reported + ".upper"));
  };
  expectSame("boundary_input_to_output", "boundary_reference_to_result");
  expectSame("boundary_output_to_input", "boundary_result_to_reference");
}

TEST(Measurement, OfClosedSurfacesHasNoBoundaries)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  EXPECT_TRUE(std::isnan(run.Value("distance.boundary_input_to_output.upper")));
}

TEST(Measurement, IsInMillimetersWhateverTheSize)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  FilterRun larger(PolyData(Scaled(SurfaceOf(Bumps(3)), 16.0)));
  larger->MeasureDistancesOn();
  EXPECT_NEAR(larger.Value("distance.output_to_input.mean"),
    16.0 * run.Value("distance.output_to_input.mean"), 1e-9);
}
