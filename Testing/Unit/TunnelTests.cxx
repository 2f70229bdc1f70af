// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Crossings.h"
#include "Run/Report/ReportTable.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// mm, of the circle that is as long as the edge of a square tunnel.
double DiameterOf(double width)
{
  return 4.0 * width / Pi;
}

/// All triangles are kept, so the result is the closed surface.
Options Closing(double diameter)
{
  Options options = Reduction(0.0);
  options.TunnelSize = diameter;
  options.KeepVoxels = KeepVoxels::Off;
  return options;
}

Surface Turned(Surface surface)
{
  for (Vector3& point : surface.Points)
  {
    point = { point[1], point[2], point[0] };
  }
  return surface;
}

std::int64_t GenusOf(const Surface& closed)
{
  const Topology topology = CountTopology(closed);
  return topology.Components - topology.EulerNumber / 2;
}

using Positions = std::array<std::array<double, 3>, 3>;

std::set<Positions> TrianglesOf(const Surface& surface)
{
  std::set<Positions> triangles;
  for (const Triangle& corners : surface.Triangles)
  {
    Positions positions;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3& p = surface.Points[static_cast<std::size_t>(corners[k])];
      positions[k] = { p[0], p[1], p[2] };
    }
    std::rotate(
      positions.begin(), std::min_element(positions.begin(), positions.end()), positions.end());
    triangles.insert(positions);
  }
  return triangles;
}

/// Checks by code of its own that so many handles went and nothing else happened.
void ExpectClosed(const Surface& input, const Result& result, std::size_t count)
{
  const TunnelFigures& tunnels = result.Report.Tunnels;
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(tunnels.Closed.size(), count);
  const Topology before = CountTopology(input);
  const Topology after = CountTopology(result.Surface);
  EXPECT_EQ(after.EulerNumber, before.EulerNumber + 2 * static_cast<std::int64_t>(count));
  EXPECT_EQ(after.Components, before.Components);
  EXPECT_EQ(after.BoundaryEdges, before.BoundaryEdges);
  EXPECT_EQ(after.NonManifoldEdges + after.InconsistentEdges, 0);
  EXPECT_EQ(CountCrossings(result.Surface), 0);
  EXPECT_EQ(tunnels.GenusBefore - tunnels.GenusAfter, static_cast<std::int64_t>(count));
  double volume = 0.0;
  for (const ClosedTunnel& tunnel : tunnels.Closed)
  {
    EXPECT_GT(tunnel.Volume, 0.0);
    volume += tunnel.Volume;
  }
  EXPECT_NEAR(SignedVolume(result.Surface) - SignedVolume(input), volume, 1e-6);
}

Report ReportOf(const Surface& input, const Options& options, const RunInputs& inputs = {})
{
  return Decimate(input, options, {}, inputs).Report;
}
}

TEST(Tunnels, OfAPlateCloseExactlyUpToTheSize)
{
  const Surface plate = DrilledPlate();
  ASSERT_EQ(GenusOf(plate), 3);
  for (const std::size_t width : { 0U, 1U, 2U, 3U })
  {
    for (const double factor : { 1.001, 1.2 })
    {
      const Result result =
        Decimate(plate, Closing(factor * DiameterOf(std::max(0.5, 1.0 * width))));
      ExpectClosed(plate, result, width);
      EXPECT_EQ(result.Report.Tunnels.NumberLeft(), 0);
    }
  }
}

TEST(Tunnels, AreListedWithTheirSizeAndPosition)
{
  const Vector3 offset(-100.0, 40.0, 8.0);
  const Report report = ReportOf(Moved(DrilledPlate(), offset), Closing(3.0));
  const std::vector<ClosedTunnel>& closed = report.Tunnels.Closed;
  ASSERT_EQ(closed.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double width = 1.0 + static_cast<double>(i);
    EXPECT_NEAR(closed[i].Diameter, DiameterOf(width), 1e-12);
    const Vector3 center = closed[i].Center - offset;
    EXPECT_NEAR(center[0], (i == 0 ? 3.5 : 8.0), 1e-12);
    EXPECT_NEAR(center[1], 3.0 + 0.5 * width, 1e-12);
    EXPECT_GE(closed[i].Volume, 0.99 * width * width);
    EXPECT_LE(closed[i].Volume, 2.01 * width * width);
  }
  const std::vector<ReportEntry> entries = ReportEntries(report);
  EXPECT_TRUE(std::any_of(entries.begin(), entries.end(),
    [](const ReportEntry& entry) { return entry.Name == "tunnels.list.1.diameter"; }));
}

TEST(Tunnels, ChangeNothingElse)
{
  const Surface plate = DrilledPlate();
  const std::set<Positions> before = TrianglesOf(plate);
  const std::set<Positions> after = TrianglesOf(Decimate(plate, Closing(1.3)).Surface);
  const auto isNearTheTunnel = [](const Positions& triangle)
  {
    return std::all_of(triangle.begin(), triangle.end(),
      [](const std::array<double, 3>& p)
      { return p[0] >= 2.0 && p[0] <= 5.0 && p[1] >= 2.0 && p[1] <= 5.0; });
  };
  for (const Positions& triangle : before)
  {
    EXPECT_TRUE(after.count(triangle) > 0 || isNearTheTunnel(triangle));
  }
  for (const Positions& triangle : after)
  {
    EXPECT_TRUE(before.count(triangle) > 0 || isNearTheTunnel(triangle));
  }
}

TEST(Tunnels, ThatAreWiderChangeNoByte)
{
  const Surface plate = DrilledPlate();
  for (const Mode mode : AllModes())
  {
    Options options = InMode(mode, Reduction(0.5));
    const Surface expected = Decimate(plate, options).Surface;
    options.TunnelSize = 1.0;
    EXPECT_TRUE(SameBytes(Decimate(plate, options).Surface, expected)) << WordOf(mode);
  }
}

TEST(Tunnels, OfARingCloseAndItsStrutIsNeverCut)
{
  for (const Surface& ring : { Torus(40, 16), Turned(Torus(40, 16)) })
  {
    for (const double size : { 5.0, 7.0, 13.5 }) // the strut is 6 thick, the tunnel 14 wide
    {
      const Result result = Decimate(ring, Closing(size));
      ExpectClosed(ring, result, 0);
      EXPECT_EQ(result.Report.Tunnels.NumberLeft(), 0) << size;
    }
    ExpectClosed(ring, Decimate(ring, Closing(14.5)), 1);
  }
}

TEST(Tunnels, OfARingShapedCavityAreItsTube)
{
  const Surface cavity = TurnedInsideOut(Torus(40, 16));
  ExpectClosed(cavity, Decimate(cavity, Closing(5.5)), 0);
  ExpectClosed(cavity, Decimate(cavity, Closing(6.1)), 1);
  ExpectClosed(cavity, Decimate(cavity, Closing(20.0)), 1); // and not the bone within the ring
}

TEST(Tunnels, OfOpenSurfacesClose)
{
  Surface plate = DrilledPlate();
  const auto isCorner = [&plate](const Triangle& corners)
  {
    return std::any_of(corners.begin(), corners.end(),
      [&](Index c) { return plate.Points[static_cast<std::size_t>(c)].norm() < 0.5; });
  };
  plate.Triangles.erase(std::remove_if(plate.Triangles.begin(), plate.Triangles.end(), isCorner),
    plate.Triangles.end());
  const Result result = Decimate(plate, Closing(3.0));
  EXPECT_EQ(result.Report.Tunnels.Closed.size(), 2U);
  EXPECT_EQ(CountTopology(result.Surface).BoundaryEdges, CountTopology(plate).BoundaryEdges);
  const Surface tube = OpenCylinder(16, 8); // its only loops are its ends
  const Report ofTube = ReportOf(tube, Closing(100.0));
  EXPECT_EQ(ofTube.Tunnels.GenusBefore, 0);
  EXPECT_TRUE(ofTube.Tunnels.Closed.empty());
}

TEST(Tunnels, DoNotDependOnTheOriginOrOnThreads)
{
  const Vector3 offset(1024.0, -512.0, 4096.0);
  const Surface plate = DrilledPlate();
  EXPECT_TRUE(SameBytes(Moved(Decimate(plate, Closing(3.0)).Surface, offset),
    Decimate(Moved(plate, offset), Closing(3.0)).Surface));
  ExpectTheSameBytesForAnyNumberOfThreads(plate, Closing(4.0));
  ExpectTheSameBytesForAnyNumberOfThreads(Torus(40, 16), Closing(14.5));
  const Surface unwelded = Unwelded(plate);
  EXPECT_EQ(ReportOf(unwelded, Closing(4.0)).Tunnels.Closed.size(), 3U);
}

TEST(Tunnels, StayWhereTheirPlugWouldIntersect)
{
  // A rod through the widest tunnel, fastened to nothing.
  Surface rod = Cube(1);
  for (Vector3& p : rod.Points)
  {
    p = { 13.2 + 0.1 * p[0], 4.3 + 0.1 * p[1], -5.0 + 13.0 * p[2] };
  }
  const Surface both = Together(DrilledPlate(), rod);
  const Result result = Decimate(both, Closing(4.0));
  ExpectClosed(both, result, 2);
  EXPECT_EQ(result.Report.Tunnels.Left[static_cast<std::size_t>(TunnelObstacle::Intersection)], 1);
  const std::vector<std::string> warnings = InputWarnings(result.Report);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& said) { return said.find("1 tunnel was left open") == 0; }));
}

TEST(Tunnels, StayAtConstrainedPointsAndBetweenLabels)
{
  const Surface plate = DrilledPlate();
  std::vector<double> tolerances;
  Labels labels;
  labels.Names = { "one", "other" };
  for (const Vector3& p : plate.Points)
  {
    tolerances.push_back(p[0] < 6.0 ? 0.0 : 0.1);
  }
  for (const Triangle& corners : plate.Triangles)
  {
    labels.OfTriangle.push_back(
      plate.Points[static_cast<std::size_t>(corners[0])][0] < 8.0 ? 0 : 1);
  }
  RunInputs inputs;
  inputs.Tolerances = &tolerances;
  const auto constrained = static_cast<std::size_t>(TunnelObstacle::Constrained);
  const Report limited = ReportOf(plate, Closing(4.0), inputs);
  EXPECT_EQ(limited.Tunnels.Closed.size(), 2U);
  EXPECT_EQ(limited.Tunnels.Left[constrained], 1);
  inputs.Tolerances = nullptr;
  inputs.Labels = &labels;
  const Report labeled = ReportOf(plate, Closing(4.0), inputs);
  EXPECT_EQ(labeled.Tunnels.Closed.size(), 2U); // the second has both labels
  EXPECT_EQ(labeled.Tunnels.Left[constrained], 1);
  EXPECT_EQ(labeled.Status, InputStatus::Good);
}

TEST(Tunnels, AreClosedBeforeTheErrorIsProved)
{
  const Surface plate = DrilledPlate();
  Options options = Error(0.2);
  options.TunnelSize = 4.0;
  options.MeasureDistances = true;
  const Result result = Decimate(plate, options, {}, { false, true });
  const Report& report = result.Report;
  EXPECT_EQ(GenusOf(result.Surface), 0);
  EXPECT_TRUE(report.Proof.WasMade);
  EXPECT_LE(report.Proof.Upper(), options.MaximumError);
  EXPECT_GT(report.Tunnels.Distance, 1.0); // the middle of the widest plug
  EXPECT_LT(report.Tunnels.Distance, 2.0);
  for (const Vector3& point : result.Surface.Points)
  {
    EXPECT_LE(BruteNearest(plate, point).Distance, options.MaximumError + report.Tunnels.Distance);
  }
  EXPECT_EQ(report.Cleaning.TrianglesRead, static_cast<std::int64_t>(plate.Triangles.size()));
  EXPECT_EQ(report.Cleaning.DroppedTriangles, 0);
  const auto triangles = static_cast<Index>(plate.Triangles.size());
  const SurfaceOrigins& origins = result.Origins;
  ASSERT_EQ(origins.NearestTriangle.size(), result.Surface.Points.size());
  for (std::size_t p = 0; p < origins.NearestTriangle.size(); ++p)
  {
    ASSERT_LT(origins.NearestTriangle[p], triangles);
    const Triangle& corners = plate.Triangles[static_cast<std::size_t>(origins.NearestTriangle[p])];
    Vector3 nearest = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      nearest += origins.Barycentric[p][k] * plate.Points[static_cast<std::size_t>(corners[k])];
    }
    EXPECT_LE((nearest - result.Surface.Points[p]).norm(), options.MaximumError + 2.0);
  }
  EXPECT_TRUE(std::all_of(origins.TriangleAtCentroid.begin(), origins.TriangleAtCentroid.end(),
    [triangles](Index triangle) { return triangle >= 0 && triangle < triangles; }));
  EXPECT_EQ(origins.OutputPoint.size(), plate.Points.size());
}

TEST(Tunnels, AreNotClosedWithWhatDoesNotGoWithThem)
{
  const Surface plate = DrilledPlate();
  EditLog log;
  const SurfacePart part;
  const LabelMapSource map;
  RunInputs recorded;
  recorded.Log = &log;
  RunInputs compared;
  compared.Reference = &plate;
  RunInputs divided;
  divided.Part = &part;
  RunInputs mapped;
  mapped.LabelMap = &map;
  std::set<std::string> messages;
  for (const RunInputs& inputs : { recorded, compared, divided, mapped })
  {
    const Result result = Decimate(plate, Closing(2.0), {}, inputs);
    EXPECT_EQ(result.Report.Status, InputStatus::OptionConflict);
    EXPECT_TRUE(result.Surface.Triangles.empty());
    messages.insert(InputMessage(result.Report));
  }
  Options guarded = Closing(2.0);
  guarded.KeepVoxels = KeepVoxels::On;
  messages.insert(InputMessage(ReportOf(plate, guarded)));
  EXPECT_EQ(messages.size(), 5U);
  EXPECT_EQ(messages.count(""), 0U);
}

TEST(Tunnels, OfAnyShapeCloseWithoutOtherChangesOfTopology)
{
  for (const NamedSurface& shape : AllShapes())
  {
    const Surface whole = Decimate(shape.Surface, Reduction(0.0)).Surface;
    const Result result = Decimate(shape.Surface, Closing(1000.0));
    if (result.Report.Status != InputStatus::Good)
    {
      continue;
    }
    const Topology before = CountTopology(whole);
    const Topology after = CountTopology(result.Surface);
    const auto closed = static_cast<std::int64_t>(result.Report.Tunnels.Closed.size());
    EXPECT_EQ(after.Components, before.Components) << shape.Name;
    EXPECT_EQ(after.EulerNumber, before.EulerNumber + 2 * closed) << shape.Name;
    EXPECT_EQ(after.BoundaryEdges, before.BoundaryEdges) << shape.Name;
    EXPECT_EQ(after.NonManifoldPoints, before.NonManifoldPoints) << shape.Name;
    EXPECT_LE(CountCrossings(result.Surface), CountCrossings(whole)) << shape.Name;
  }
}

TEST(Tunnels, AreLeftAfterAnAbort)
{
  const Result result = Decimate(DrilledPlate(), Closing(4.0), [](double) { return false; });
  EXPECT_EQ(result.Report.Stop, StopReason::Aborted);
  EXPECT_TRUE(result.Report.Tunnels.Closed.empty());
  EXPECT_EQ(GenusOf(result.Surface), 3);
}
