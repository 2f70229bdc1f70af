// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices of high valence: work that grows with the triangles and not with their square, and
// results as small as they should be.
#include "Decimate/Schedule/BucketSweep.h"
#include "EditAlone.h"
#include "Geometry/BoundingTree.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Radius = 10.0; // mm

Vector3 OnCircle(Index i, Index count, double z, double radius = Radius)
{
  const double angle = 2.0 * 3.14159265358979 * i / count;
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/// A disk around one vertex.
Surface Disk(Index sides)
{
  Surface disk;
  for (Index i = 0; i < sides; ++i)
  {
    disk.Points.push_back(OnCircle(i, sides, 0.0));
    disk.Triangles.push_back({ i, (i + 1) % sides, sides });
  }
  disk.Points.push_back(Vector3::Zero());
  return disk;
}

/// Closed: two fans with one rim, whose radius alternates between both.
Surface TwoFans(Index sides, double radius, double height)
{
  Surface fans;
  for (Index i = 0; i < sides; ++i)
  {
    fans.Points.push_back(OnCircle(i, sides, 0.0, i % 2 == 0 ? Radius : radius));
    fans.Triangles.push_back({ i, (i + 1) % sides, sides });
    fans.Triangles.push_back({ (i + 1) % sides, i, sides + 1 });
  }
  fans.Points.push_back({ 0.0, 0.0, height });
  fans.Points.push_back({ 0.0, 0.0, -height });
  return fans;
}

/// A cylinder whose caps are fans.
Surface Implant(Index sides)
{
  constexpr double height = 30.0; // mm
  Surface implant;
  for (Index i = 0; i < sides; ++i)
  {
    const Index next = (i + 1) % sides;
    implant.Points.push_back(OnCircle(i, sides, 0.0));
    implant.Triangles.push_back({ i, next, sides + next });
    implant.Triangles.push_back({ i, sides + next, sides + i });
    implant.Triangles.push_back({ 2 * sides, next, i });
    implant.Triangles.push_back({ 2 * sides + 1, sides + i, sides + next });
  }
  for (Index i = 0; i < sides; ++i)
  {
    implant.Points.push_back(OnCircle(i, sides, height));
  }
  implant.Points.push_back(Vector3::Zero());
  implant.Points.push_back({ 0.0, 0.0, height });
  return implant;
}

/// Faces that all edits of a sweep change, at the merged vertices.
std::int64_t ChangedFaces(const Surface& surface, double error)
{
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.KeepsAreas = false;
  settings.KeepsQuadrics = true;
  if (error > 0.0)
  {
    settings.Bound = ErrorBoundSettings{ error };
  }
  const CleanSurface cleaned = Clean(surface, true);
  Editor editor(cleaned, settings);
  std::int64_t faces = 0;
  editor.SetHook(
    [&faces](const Editor& at, const Edit& edit)
    {
      const Index changed = at.Mesh().OutgoingOf(edit.Keep).Count();
      EXPECT_LE(changed, MaxFacesOfEdit);
      faces += changed;
    });
  BucketSweep(editor, 1).Run({ 64, 0.0 }, [](double) { return true; });
  EXPECT_GT(editor.Totals().Collapses, 0);
  return faces;
}

/// Triangles that a search for the nearest point visits, on average.
double VisitsOfQuery(const Surface& surface)
{
  const BoundingTree tree(surface);
  constexpr Index queries = 500;
  std::int64_t visits = 0;
  for (Index i = 0; i < queries; ++i)
  {
    const Vector3 p = OnCircle(7 * i, queries, 0.01, Radius * (0.2 + 0.7 * i / queries));
    double squared = Infinity;
    tree.VisitNear(p, squared,
      [&](Index triangle)
      {
        ++visits;
        const Triangle& t = surface.Triangles[triangle];
        squared = std::min(squared,
          NearestOnTriangle(p, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]])
            .SquaredDistance);
      });
  }
  return static_cast<double>(visits) / queries;
}
}

TEST(Hub, NoEdgeOfAHubIsCollapsed)
{
  for (const Index sides : { MaxFacesOfEdit / 2, 4 * MaxFacesOfEdit })
  {
    const CleanSurface cleaned = Clean(TwoFans(sides, Radius, 5.0), true);
    Editor editor(cleaned, EditorSettings());
    const HalfEdgeMesh& mesh = editor.Mesh();
    const bool isHub = sides > MaxFacesOfEdit;
    Index hubs = 0;
    for (const Index h : HalfEdges(mesh))
    {
      const bool isAtHub = IsHub(mesh, mesh.Origin(h)) || IsHub(mesh, mesh.Target(h));
      EXPECT_EQ(GatherAlone(editor, h) == Rejection::Valence, isAtHub);
      hubs += isAtHub ? 1 : 0;
    }
    EXPECT_EQ(hubs > 0, isHub);
  }
}

TEST(Hub, AHubDoesNotMoveAndNoFlipJoinsTwo)
{
  const Index sides = 4 * MaxFacesOfEdit;
  const CleanSurface cleaned = Clean(TwoFans(sides, Radius, 5.0), true);
  Editor editor(cleaned, EditorSettings());
  const HalfEdgeMesh& mesh = editor.Mesh();
  EditWorkspace work;
  for (const Index h : HalfEdges(mesh))
  {
    const VertexId v = mesh.Origin(h);
    if (IsHub(mesh, v))
    {
      EXPECT_EQ(editor.Try(MoveTo(v, mesh.Position(v)), work).Reason(), Rejection::Valence);
    }
    else if (!IsHub(mesh, mesh.Target(h)))
    {
      EXPECT_EQ(editor.Try(FlipOf(h), work).Reason(), Rejection::Valence);
    }
  }
}

TEST(Hub, EditsChangeFacesInProportionToTheTriangles)
{
  for (const double error : { 0.0, 0.1 })
  {
    for (Surface (*shape)(Index) : { Disk, Implant })
    {
      const std::int64_t few = ChangedFaces(shape(600), error);
      EXPECT_LT(ChangedFaces(shape(2400), error), 6 * few) << error;
    }
  }
}

TEST(Hub, AQueryVisitsFewNeedles)
{
  for (Surface (*shape)(Index) : { Disk, Implant })
  {
    const double few = VisitsOfQuery(shape(500));
    EXPECT_LT(few, 40.0);
    EXPECT_LT(VisitsOfQuery(shape(8000)), 2.0 * few);
  }
}

TEST(Hub, NeedlesAreAsNearAsByBruteForce)
{
  const Surface star = TwoFans(200, 3.0, 1.0);
  const BoundingTree tree(star);
  for (Index i = 0; i < 300; ++i)
  {
    const Vector3 p = OnCircle(7 * i, 300, 0.02 * i - 3.0, 0.04 * i);
    Index least = None;
    double squared = Infinity;
    for (std::size_t k = 0; k < star.Triangles.size(); ++k)
    {
      const Triangle& t = star.Triangles[k];
      const double distance =
        NearestOnTriangle(p, star.Points[t[0]], star.Points[t[1]], star.Points[t[2]])
          .SquaredDistance;
      least = distance < squared ? static_cast<Index>(k) : least;
      squared = std::min(squared, distance);
    }
    EXPECT_EQ(tree.FindNearest(p).Triangle, least);
  }
}

/// A circle takes pi / acos(1 - error / radius) / 2 corners or a few more if the polygon lies on
/// both sides of it.
TEST(Hub, FansBecomeSmallWithinTheError)
{
  constexpr double error = 0.1; // mm
  const double corners = 3.14159265 / std::acos(1.0 - error / Radius);
  const Surface shapes[] = { Disk(400), TwoFans(400, Radius, 0.0005), Implant(400),
    TwoFans(400, Radius, 6.0) };
  for (const Surface& input : shapes)
  {
    for (const Mode mode : { Mode::Fast, Mode::Balanced })
    {
      const Result result = Decimate(input, InMode(mode, ErrorOfAnySize(error)));
      EXPECT_LE(result.Surface.Triangles.size(), 5.0 * corners) << WordOf(mode);
      EXPECT_EQ(CountTopology(result.Surface).EulerNumber, CountTopology(input).EulerNumber);
      EXPECT_LE(Certify(input, result.Surface).Upper(), error);
    }
  }
}

TEST(Hub, NeedlesOfAStarStayWhereTheErrorIsSmall)
{
  const Surface star = TwoFans(400, 3.0, 1.0);
  const Result result = Decimate(star, InMode(Mode::Fast, Error(0.01)));
  EXPECT_GT(result.Surface.Triangles.size(), 700U);
  EXPECT_LE(Certify(star, result.Surface).Upper(), 0.01);
}
