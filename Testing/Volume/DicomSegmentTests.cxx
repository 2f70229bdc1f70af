// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Dicom/CielabColor.h"
#include "Dicom/DicomText.h"
#include "Dicom/FrameGrid.h"
#include "Dicom/SegmentFrames.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bonedecimate::testing
{
namespace
{
using namespace volume;

/// Frames of 10 x 20 pixels at these heights, mm.
std::vector<FramePlacement> FramesAt(const std::vector<double>& heights)
{
  FramePlacement frame;
  frame.AlongRow = { { 1.0, 0.0, 0.0 } };
  frame.AlongColumn = { { 0.0, 0.0, -1.0 } };
  frame.RowDistance = 0.75;
  frame.ColumnDistance = 0.5;
  std::vector<FramePlacement> frames;
  for (const double height : heights)
  {
    frame.Position = { { 7.0, height, 3.0 } };
    frames.push_back(frame);
  }
  return frames;
}

FrameGrid GridAt(const std::vector<double>& heights, double distance)
{
  return GridOfFrames(FramesAt(heights), distance, { { 10, 20 } });
}

TEST(DicomFrames, LieOnAGridInTheOrderOfTheirPositions)
{
  const FrameGrid grid = GridAt({ 4.0, 1.0, 2.5, 1.0 }, 0.0);
  ASSERT_EQ(grid.Problem, "");
  EXPECT_EQ(grid.Planes, 3);
  EXPECT_EQ(grid.PlaneOf, std::vector<std::int64_t>({ 2, 0, 1, 0 }));
  EXPECT_EQ(grid.Geometry.Origin, Vector3({ { 7.0, 1.0, 3.0 } }));
  EXPECT_EQ(grid.Geometry.Steps[0], Vector3({ { 0.5, 0.0, 0.0 } }));
  EXPECT_EQ(grid.Geometry.Steps[1], Vector3({ { 0.0, 0.0, -0.75 } }));
  EXPECT_EQ(grid.Geometry.Steps[2], Vector3({ { 0.0, 1.5, 0.0 } }));
  EXPECT_GT(Determinant(grid.Geometry), 0.0);
}

TEST(DicomFrames, MayLeaveOutPlanes)
{
  const FrameGrid grid = GridAt({ 0.0, 1.0, 4.0 }, 0.5);
  ASSERT_EQ(grid.Problem, "");
  EXPECT_EQ(grid.PlaneOf, std::vector<std::int64_t>({ 0, 2, 8 }));
  EXPECT_EQ(grid.Planes, 9);
  EXPECT_EQ(grid.PlanesWithoutFrames, 6);
}

TEST(DicomFrames, MayBeRoundedWithoutADrift)
{
  std::vector<double> heights(400);
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    heights[k] = std::round(6.25 * static_cast<double>(k)) / 10.0;
  }
  const FrameGrid grid = GridAt(heights, 0.0);
  ASSERT_EQ(grid.Problem, "");
  EXPECT_EQ(grid.Planes, 400);
  EXPECT_EQ(grid.PlanesWithoutFrames, 0);
  EXPECT_NEAR(grid.Geometry.Steps[2][1], 0.625, 2e-4);
}

TEST(DicomFrames, ThatAreNotEvenlySpacedAreRejected)
{
  for (const double distance : { 0.0, 1.0, 0.5, 1e-12, HUGE_VAL, std::nan("") })
  {
    EXPECT_NE(GridAt({ 0.0, 1.0, 2.0, 3.3, 4.3 }, distance).Problem, "") << distance;
    EXPECT_EQ(GridAt({ 0.0, 1.0, 2.0, 3.0 }, distance == 0.5 ? 0.0 : distance).Planes, 4);
  }
  EXPECT_NE(GridAt({ 0.0, 1.0, 1e15 }, 1.0).Problem, "");
  EXPECT_NE(GridAt({ 0.0, 1.0, HUGE_VAL }, 1.0).Problem, "");
}

TEST(DicomFrames, HaveTheLabelOfTheLastSegmentAndCountVoxelsOfSeveralOnce)
{
  std::vector<Segment> segments(3);
  segments[0].Label = 4;
  segments[1].Label = 2;
  segments[2].Label = 9;
  // Pixels of 3 x 1, three frames without gaps: 110, 011, 111.
  const std::vector<unsigned char> bytes{ 0b11110011, 0b1 };
  SegmentFrames frames(SegmentPixels::Bits, bytes, { { 3, 1 } }, segments);
  ASSERT_EQ(frames.Arrange({ { 1, 0 }, { 0, 0 }, { 2, 2 } }, 3), "");
  std::array<std::uint16_t, 3> labels{};
  EXPECT_EQ(frames.Combine(0, labels.data()).Voxels, 1);
  EXPECT_EQ(labels, (std::array<std::uint16_t, 3>{ { 2, 2, 4 } }));
  EXPECT_EQ(frames.Combine(1, labels.data()).Voxels, 0);
  EXPECT_EQ(labels, (std::array<std::uint16_t, 3>{}));
  frames.Combine(2, labels.data());
  EXPECT_EQ(labels, (std::array<std::uint16_t, 3>{ { 9, 9, 9 } }));
}

TEST(DicomFrames, OfSegmentsThatAreNotChosenCoverNoOthers)
{
  std::vector<Segment> segments(3);
  segments[0].Label = 4;
  segments[1].Label = 2;
  segments[2].Label = 9;
  const std::vector<unsigned char> bytes{ 0b11110011, 0b1 };
  SegmentFrames frames(SegmentPixels::Bits, bytes, { { 3, 1 } }, segments);
  ASSERT_EQ(frames.Arrange({ { 1, 0 }, { 0, 0 }, { 2, 2 } }, 3, { true, false, true }), "");
  std::array<std::uint16_t, 3> labels{};
  EXPECT_EQ(frames.Combine(0, labels.data()).Voxels, 0);
  EXPECT_EQ(labels, (std::array<std::uint16_t, 3>{ { 0, 4, 4 } }));
}

TEST(DicomColors, AreThoseOfSrgb)
{
  // White, black, and the red of sRGB: L* 53.24, a* 80.09, b* 67.20.
  const auto near = [](const std::array<double, 3>& a, const std::array<double, 3>& b)
  { return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 0.01; };
  EXPECT_TRUE(near(ColorOfCielab({ { 65535, 32896, 32896 } }), { { 1.0, 1.0, 1.0 } }));
  EXPECT_TRUE(near(ColorOfCielab({ { 0, 32896, 32896 } }), { { 0.0, 0.0, 0.0 } }));
  EXPECT_TRUE(near(ColorOfCielab({ { 34891, 53479, 50167 } }), { { 1.0, 0.0, 0.0 } }));
}

TEST(DicomNames, BecomeUtf8)
{
  EXPECT_EQ(Utf8Of("Sch\xe4"
                   "del",
              "ISO_IR 100"),
    "Sch\xc3\xa4"
    "del");
  EXPECT_EQ(Utf8Of("\xda\xde\xe1\xe2\xec", "ISO 2022 IR 144\\ISO 2022 IR 13"),
    "\xd0\xba\xd0\xbe\xd1\x81\xd1\x82\xd1\x8c");
  EXPECT_EQ(Utf8Of("a\xff\xc3\xa4", "ISO_IR 192"), "a?\xc3\xa4");
  EXPECT_EQ(Utf8Of("a\xff", "unknown"), "a?");
  EXPECT_EQ(Utf8Of(std::string(2000, '\xe4'), "").size(), 4000U);
}
}
}
