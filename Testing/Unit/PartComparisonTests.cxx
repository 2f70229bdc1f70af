// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Area, volume and thickness of components and labels, and the warnings about them.
#include "LabelMaps.h"
#include "LabeledSurfaces.h"
#include "Mesh/SurfaceParts.h"
#include "NoisyBones.h"
#include "Proof/Measure/Thickness.h"
#include "Run/Report/ReportTable.h"
#include "Runs.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Options Measuring(Options options)
{
  options.MeasureDistances = true;
  return options;
}

/// From -half to half.
Surface Box(const Vector3& half, Index cells)
{
  Surface box = Cube(cells);
  for (Vector3& p : box.Points)
  {
    p = (2.0 * p - Vector3::Ones()).cwiseProduct(half);
  }
  return box;
}

/// All normals point out of the one solid.
ThicknessChange ThicknessOf(const Surface& before, const Surface& after)
{
  const BoundingTree ofBefore(before);
  const BoundingTree ofAfter(after);
  return CompareThickness(
    { before, ofBefore, nullptr }, { after, ofAfter, nullptr }, after.Triangles, 0, 500, 1);
}

bool Warns(const Report& report, const std::string& about)
{
  const std::vector<std::string> warnings = InputWarnings(report);
  return std::any_of(warnings.begin(), warnings.end(),
    [&](const std::string& warning) { return warning.find(about) != std::string::npos; });
}

/// Whether a voxel is in a bar of that many voxels along the axes, two voxels from the first one.
bool IsInBar(const std::array<Index, 3>& voxel, const std::array<Index, 3>& size)
{
  bool isIn = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    isIn = isIn && voxel[axis] >= 2 && voxel[axis] < 2 + size[axis];
  }
  return isIn;
}

Result SmoothedBar(const std::array<Index, 3>& size)
{
  const LabelSurfaces bar = Extracted(MakeLabelMap({ size[0] + 4, size[1] + 4, size[2] + 4 },
    [&](const std::array<Index, 3>& voxel) { return IsInBar(voxel, size) ? 1 : 0; }));
  return Decimate(bar.Surface, Smoothed(0.45, Reduction(0.0)));
}
}

TEST(SurfaceParts, OfComponentsHaveTheirAreaVolumeAndBox)
{
  const Surface open = Moved(Grid(3), { 5.0, 0.0, 0.0 });
  const Surface surface =
    Together(Together(Icosphere(2, 2.0), Moved(Box({ 1.0, 2.0, 3.0 }, 2), { 9, 9, 9 })), open);
  const SurfaceParts parts = ComponentsAsParts(surface);
  const std::vector<PartExtent> extents = MeasureParts(surface.Points, surface.Triangles, parts);
  ASSERT_EQ(extents.size(), 3U);
  const std::vector<Surface> components = SplitComponents(surface);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(extents[i].Triangles, static_cast<std::int64_t>(components[i].Triangles.size()));
    EXPECT_NEAR(extents[i].Area, TotalArea(components[i]), 1e-9);
    EXPECT_EQ(extents[i].IsClosed, i < 2) << i;
  }
  EXPECT_NEAR(extents[0].Volume, SignedVolume(Icosphere(2, 2.0)), 1e-9);
  EXPECT_NEAR(extents[1].Volume, 48.0, 1e-9);
  EXPECT_TRUE(extents[1].Low.isApprox(Vector3(8, 7, 6)));
  EXPECT_TRUE(extents[1].High.isApprox(Vector3(10, 11, 12)));
}

TEST(SurfaceParts, AreOpenWhereATriangleIsMissingOrTurned)
{
  Surface turned = Icosphere(1, 1.0);
  std::swap(turned.Triangles[7][0], turned.Triangles[7][1]);
  Surface holed = Icosphere(1, 1.0);
  holed.Triangles.erase(holed.Triangles.begin() + 7);
  // Both ends of the cylinder have the same area: the sum of all area vectors is 0.
  for (const Surface& surface : { turned, holed, OpenCylinder(12, 4) })
  {
    const SurfaceParts parts = ComponentsAsParts(surface);
    EXPECT_FALSE(MeasureParts(surface.Points, surface.Triangles, parts).front().IsClosed);
  }
  const Surface pinched = PinchedSolids(8);
  const SurfaceParts parts = ComponentsAsParts(pinched);
  EXPECT_TRUE(MeasureParts(pinched.Points, pinched.Triangles, parts).front().IsClosed);
}

TEST(SurfaceParts, OfLabelsHaveTheVolumeOfTheirVoxels)
{
  const std::array<Index, 3> size = { 5, 4, 6 };
  const auto labelOf = [&](const std::array<Index, 3>& voxel) {
    return voxel[2] < 2 ? 0 : voxel[0] < 2 ? 1 : voxel[2] == 4 ? 2 : 3;
  };
  std::array<double, 4> voxels = {};
  const LabelMap map = MakeLabelMap(size, labelOf);
  for (const std::int32_t label : map.Labels)
  {
    voxels[static_cast<std::size_t>(label)] += 1.0;
  }
  const BlockComplex blocks = BlocksOf(size, labelOf);
  SurfaceParts parts;
  parts.Count = 3;
  for (const BoundaryLabels& pair : blocks.Labels)
  {
    parts.OfTriangle.push_back({ pair[0] - 1, pair[1] - 1 }); // 0 is the background
  }
  const std::vector<PartExtent> extents =
    MeasureParts(blocks.Surface.Points, blocks.Surface.Triangles, parts);
  for (std::size_t part = 0; part < 3; ++part)
  {
    EXPECT_TRUE(extents[part].IsClosed) << part;
    EXPECT_NEAR(extents[part].Volume, voxels[part + 1], 1e-9) << part;
  }
}

TEST(Thickness, IsTheLengthOfLinesThroughThePart)
{
  const ThicknessChange plate = ThicknessOf(Box({ 10, 10, 1.0 }, 12), Box({ 10, 10, 0.7 }, 12));
  EXPECT_NEAR(plate.Before.Median, 2.0, 1e-6);
  EXPECT_NEAR(plate.After.Median, 1.4, 1e-6);
  EXPECT_NEAR(plate.Before.Percentile5, 2.0, 1e-6);
  EXPECT_NEAR(plate.After.Percentile5, 1.4, 1e-6);
  const ThicknessChange grown = ThicknessOf(Box({ 10, 10, 0.7 }, 12), Box({ 10, 10, 1.0 }, 12));
  EXPECT_NEAR(grown.Before.Median, 1.4, 1e-6);
  EXPECT_NEAR(grown.After.Median, 2.0, 1e-6);
}

TEST(Thickness, EndsAtACavity)
{
  const Surface hollow = Together(Icosphere(3, 5.0), TurnedInsideOut(Icosphere(3, 4.0)));
  const ThicknessChange wall = ThicknessOf(hollow, hollow);
  EXPECT_NEAR(wall.Before.Median, 1.0, 0.02);
  EXPECT_NEAR(wall.After.Median, 1.0, 0.02);
}

TEST(Thickness, IsNotKnownOfAPlaneSurface)
{
  const Surface plane = Grid(4);
  const ThicknessChange found = ThicknessOf(plane, plane);
  EXPECT_TRUE(std::isnan(found.Before.Median));
  EXPECT_TRUE(std::isnan(found.After.Percentile5));
}

TEST(PartComparison, ComparesTheComponentsOfInputAndResult)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(4.0)), 5.0, Cubic);
  const BinarySurface plate = MarchedShape(BoxShape({ 4.0, 4.0, 0.8 }), 5.0, Cubic);
  const Surface input = Together(plate.Surface, Moved(ball.Surface, { 20.0, 0.0, 0.0 }));
  const Result result = Decimate(input, Measuring(Smoothed(0.1, Error(0.25))));
  const PartComparison& compared = result.Report.Parts;
  ASSERT_EQ(compared.Of, PartComparison::Kind::Components);
  ASSERT_EQ(compared.Parts.size(), 2U);
  EXPECT_NEAR(compared.MinVolume, 27.0 * 0.125, 1e-6);
  std::vector<Surface> after = SplitComponents(result.Surface);
  std::sort(after.begin(), after.end(),
    [](const Surface& a, const Surface& b) { return SignedVolume(a) > SignedVolume(b); });
  const Surface* before[] = { &ball.Surface, &plate.Surface };
  for (std::size_t i = 0; i < 2; ++i) // the ball has the larger area
  {
    const PartFigures& part = compared.Parts[i];
    EXPECT_EQ(part.Label, "");
    EXPECT_NEAR(part.Input.Area, TotalArea(*before[i]), 1e-6);
    EXPECT_NEAR(part.Input.Volume, SignedVolume(*before[i]), 1e-6);
    EXPECT_NEAR(part.Output.Area, TotalArea(after[i]), 1e-6);
    EXPECT_NEAR(part.Output.Volume, SignedVolume(after[i]), 1e-6);
    EXPECT_LT(std::abs(part.VolumeChange()), 0.1);
  }
  EXPECT_NEAR(compared.Parts[0].Center[0], 20.0, 0.5);
  // Three voxels of .5 mm, and within a voxel of it after simplification.
  EXPECT_NEAR(compared.Parts[1].Input.Thickness.Median, 1.5, 0.01);
  EXPECT_NEAR(compared.Parts[1].Output.Thickness.Median, 1.5, 0.5);
  EXPECT_FALSE(Warns(result.Report, "changed by more than"));
}

TEST(PartComparison, ComparesWhatLabelsEnclose)
{
  const LabelMap map = EllipsoidLabels({ 25, 22, 20 });
  const LabelSurfaces surfaces = Extracted(map);
  RunInputs inputs;
  inputs.LabelMap = &surfaces.Source;
  const Result result =
    Decimate(surfaces.Surface, Measuring(Smoothed(0.3, Reduction(0.5))), {}, inputs);
  const PartComparison& compared = result.Report.Parts;
  ASSERT_EQ(compared.Of, PartComparison::Kind::Labels);
  ASSERT_EQ(compared.Parts.size(), 3U);
  double input = 0.0;
  double output = 0.0;
  for (const PartFigures& part : compared.Parts)
  {
    EXPECT_GT(part.Input.Volume, 0.0) << part.Label;
    EXPECT_LT(std::abs(part.VolumeChange()), 0.1) << part.Label;
    const auto voxels = std::count(map.Labels.begin(), map.Labels.end(), std::stoi(part.Label));
    EXPECT_NEAR(part.Input.Volume, static_cast<double>(voxels), 0.2 * static_cast<double>(voxels));
    EXPECT_GT(part.Input.Thickness.Median, 1.0) << part.Label;
    EXPECT_NEAR(part.Output.Thickness.Median, part.Input.Thickness.Median, 1.5) << part.Label;
    input += part.Input.Volume;
    output += part.Output.Volume;
  }
  // Together the labels fill the outer surface: walls count for both sides.
  const auto outside = [&](const Surface& surface, const std::vector<BoundaryLabels>& pairs)
  {
    Surface outer;
    outer.Points = surface.Points;
    for (std::size_t t = 0; t < pairs.size(); ++t)
    {
      if (pairs[t][1] == surfaces.Source.Background())
      {
        outer.Triangles.push_back(surface.Triangles[t]);
      }
    }
    return SignedVolume(outer);
  };
  EXPECT_NEAR(input, outside(surfaces.Surface, surfaces.Source.OfTriangle), 1e-6);
  EXPECT_NEAR(output, outside(result.Surface, result.BoundaryLabels), 1e-6);
}

TEST(PartComparison, ComparesTheTrianglesOfLabels)
{
  const Surface input = Icosphere(4, 10.0);
  const Labels labels = ThreeParts(input);
  RunInputs inputs;
  inputs.Labels = &labels;
  const Result result = Decimate(input, Smoothed(0.3, Reduction(0.5)), {}, inputs);
  const PartComparison& compared = result.Report.Parts;
  ASSERT_EQ(compared.Of, PartComparison::Kind::Labels);
  ASSERT_EQ(compared.Parts.size(), 3U);
  for (const PartFigures& part : compared.Parts)
  {
    const auto area = std::find_if(result.Report.Labels.begin(), result.Report.Labels.end(),
      [&](const LabelArea& label) { return label.Name == part.Label; });
    ASSERT_NE(area, result.Report.Labels.end());
    EXPECT_NEAR(part.Input.Area, area->Input, 1e-9);
    EXPECT_NEAR(part.Output.Area, area->Output, 1e-6);
    EXPECT_TRUE(std::isnan(part.Input.Volume)) << "a piece of a surface encloses nothing";
    EXPECT_TRUE(std::isnan(part.Output.Volume));
  }
}

TEST(PartComparison, IsOfSmoothedSurfacesAlone)
{
  const Surface input = Icosphere(3, 10.0);
  EXPECT_EQ(Decimate(input, Reduction(0.5)).Report.Parts.Of, PartComparison::Kind::NotCompared);
  const PartComparison compared = Decimate(input, Smoothed(0.1, Reduction(0.5))).Report.Parts;
  EXPECT_EQ(compared.Of, PartComparison::Kind::Components);
  EXPECT_NEAR(compared.MinVolume, 27.0 * 0.008, 1e-9) << "of twice the bound without a grid";
  EXPECT_TRUE(std::isnan(compared.Parts.front().Input.Thickness.Median)) << "not measured";
}

TEST(PartComparison, GivesTheSameFiguresForAnyNumberOfThreads)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(5.0)), 6.0, Cubic);
  Options options = Measuring(Smoothed(0.2, Reduction(0.5)));
  const PartFigures one = Decimate(ball.Surface, options).Report.Parts.Parts.front();
  options.NumberOfThreads = 3;
  const PartFigures three = Decimate(ball.Surface, options).Report.Parts.Parts.front();
  EXPECT_EQ(one.Output.Volume, three.Output.Volume);
  EXPECT_EQ(one.Input.Thickness.Median, three.Input.Thickness.Median);
  EXPECT_EQ(one.Output.Thickness.Percentile5, three.Output.Thickness.Percentile5);
}

TEST(PartWarnings, AreOfThinPartsAndNotOfSpecks)
{
  // Both lose more than a tenth; a speck of two voxels is smaller than 27 voxels.
  for (const auto& [size, warns] : { std::pair(std::array<Index, 3>{ 2, 2, 16 }, true),
         std::pair(std::array<Index, 3>{ 2, 1, 1 }, false) })
  {
    const Report report = SmoothedBar(size).Report;
    ASSERT_EQ(report.Parts.Parts.size(), 1U);
    EXPECT_LT(report.Parts.Parts.front().VolumeChange(), -0.1);
    EXPECT_EQ(Warns(report, "the volume of 1 components changed"), warns);
  }
}

TEST(PartWarnings, AreOfPartsThatLostVolumeOrThickness)
{
  Report report;
  report.Parts.Of = PartComparison::Kind::Labels;
  report.Parts.MinVolume = 27.0;
  PartFigures part;
  part.Label = "7";
  part.Input = { 100.0, 50.0, { 3.0, 1.0 } };
  for (const auto& [volume, median, thin, warnsOfVolume, warnsOfThickness] :
    { std::tuple(46.0, 2.5, 0.85, false, false), std::tuple(44.0, 2.5, 0.85, true, false),
      std::tuple(56.0, 3.5, 1.5, true, false), std::tuple(50.0, 2.3, 1.0, false, true),
      std::tuple(50.0, 3.0, 0.75, false, true) })
  {
    part.Output = { 90.0, volume, { median, thin } };
    report.Parts.Parts = { part };
    EXPECT_EQ(Warns(report, "the volume of 1 labels"), warnsOfVolume) << volume;
    EXPECT_EQ(Warns(report, "the thickness of 1 labels"), warnsOfThickness) << median;
    EXPECT_EQ(Warns(report, "label 7"), warnsOfVolume || warnsOfThickness);
  }
  report.Parts.MinVolume = 51.0;
  EXPECT_FALSE(Warns(report, "label 7")) << "too small";
  // An open part has no volume: its area counts.
  report.Parts.Parts.front().Input.Volume = std::nan("");
  EXPECT_TRUE(Warns(report, "label 7")) << "a cube of 51 mm3 has 83 mm2";
  report.Parts.MinVolume = 70.0;
  EXPECT_FALSE(Warns(report, "label 7")) << "a cube of 70 mm3 has 102 mm2";
}

TEST(PartComparison, IsInTheReportWithTheLargestParts)
{
  Report report;
  report.Parts.Of = PartComparison::Kind::Components;
  report.Parts.Parts.resize(40);
  report.Parts.Parts[0].Input = { 12.0, 3.0, { 2.0, 1.0 } };
  report.Parts.Parts[0].Center = { 1.0, 2.0, 3.0 };
  std::map<std::string, ReportValue> values;
  for (const ReportEntry& entry : ReportEntries(report))
  {
    values[entry.Name] = entry.Value;
  }
  EXPECT_EQ(values.at("parts.kind"), ReportValue(std::string("components")));
  EXPECT_EQ(values.at("parts.count"), ReportValue(std::int64_t{ 40 }));
  EXPECT_EQ(values.at("parts.list.0.input.volume"), ReportValue(3.0));
  EXPECT_EQ(values.at("parts.list.0.input.thickness_percentile_5"), ReportValue(1.0));
  EXPECT_EQ(values.at("parts.list.0.center.2"), ReportValue(3.0));
  EXPECT_EQ(values.count("parts.list.0.output.volume"), 0U) << "not known";
  EXPECT_EQ(values.count("parts.list.0.label"), 0U);
  EXPECT_EQ(values.count("parts.list.31.triangles"), 1U);
  EXPECT_EQ(values.count("parts.list.32.triangles"), 0U);
}
