// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/EdgeMatching.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Half-edges by their edge, and what follows from that by the rules as they are written.
struct BruteMatching
{
  std::map<std::pair<Index, Index>, std::vector<Index>> OnEdge;
  std::vector<Index> Twins;
  EdgeCounts Counts;

  explicit BruteMatching(const std::vector<Triangle>& triangles)
    : Twins(4 * triangles.size(), None)
  {
    const auto corner = [&](Index h) { return triangles[h / 4][h % 4 % 3]; };
    const auto target = [&](Index h) { return triangles[h / 4][(h % 4 + 1) % 3]; };
    for (Index f = 0; f < static_cast<Index>(triangles.size()); ++f)
    {
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
      {
        this->OnEdge[std::minmax(corner(h), target(h))].push_back(h);
      }
    }
    for (const auto& [ends, group] : this->OnEdge)
    {
      ++this->Counts.Edges;
      this->Counts.Boundary += group.size() == 1 ? 1 : 0;
      this->Counts.NonManifold += group.size() > 2 ? 1 : 0;
      const bool isPair = group.size() == 2 && corner(group[0]) == target(group[1]) &&
        corner(group[0]) != target(group[0]);
      for (std::size_t i = 0; i < group.size() && group.size() > 1; ++i)
      {
        this->Twins[group[i]] = isPair ? group[1 - i] : OddEdge;
      }
    }
  }
};

/// Triangles at the point, joined across twins: one set is one fan.
bool IsOneFan(const std::vector<Triangle>& triangles, const std::vector<Index>& twins, Index point)
{
  std::set<Index> faces;
  for (Index f = 0; f < static_cast<Index>(triangles.size()); ++f)
  {
    const Triangle& t = triangles[f];
    if (std::find(t.begin(), t.end(), point) != t.end())
    {
      faces.insert(f);
    }
  }
  std::set<Index> reached = { *faces.begin() };
  std::vector<Index> waiting = { *faces.begin() };
  while (!waiting.empty())
  {
    const Index f = waiting.back();
    waiting.pop_back();
    for (Index k = 0; k < 3; ++k)
    {
      const bool atPoint = triangles[f][k] == point || triangles[f][(k + 1) % 3] == point;
      const Index twin = twins[4 * f + k];
      if (atPoint && twin >= 0 && reached.insert(twin / 4).second)
      {
        waiting.push_back(twin / 4);
      }
    }
  }
  return reached == faces;
}

VertexConstraint BruteKind(
  const BruteMatching& brute, const std::vector<Triangle>& triangles, Index point)
{
  bool odd = false;
  bool boundary = false;
  for (const auto& [ends, group] : brute.OnEdge)
  {
    if (ends.first == point || ends.second == point)
    {
      odd = odd || brute.Twins[group[0]] == OddEdge;
      boundary = boundary || brute.Twins[group[0]] == None;
    }
  }
  if (odd || !IsOneFan(triangles, brute.Twins, point))
  {
    return VertexConstraint::NonManifold;
  }
  return boundary ? VertexConstraint::Boundary : VertexConstraint::Free;
}

void ExpectMatched(const Surface& surface)
{
  const BruteMatching brute(surface.Triangles);
  for (const int threads : { 1, 3 })
  {
    const EdgeMatching matching(surface.Triangles, surface.Points.size(), threads);
    EXPECT_EQ(std::vector<Index>(matching.Twins().begin(), matching.Twins().end()), brute.Twins);
    const EdgeCounts counts = matching.CountEdges();
    EXPECT_EQ(counts.Edges, brute.Counts.Edges);
    EXPECT_EQ(counts.Boundary, brute.Counts.Boundary);
    EXPECT_EQ(counts.NonManifold, brute.Counts.NonManifold);
  }
}

void ExpectRings(const Surface& surface)
{
  const BruteMatching brute(surface.Triangles);
  const Rings rings = EdgeMatching(surface.Triangles, surface.Points.size(), 2).FindRings();
  LargeArray<Index> outgoing(surface.Points.size(), None);
  for (Index f = 0; f < static_cast<Index>(surface.Triangles.size()); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      Index& h = outgoing[surface.Triangles[f][k]];
      h = h == None || brute.Twins[4 * f + k] < 0 ? 4 * f + k : h;
    }
  }
  EXPECT_EQ(rings.Outgoing, outgoing);
  for (Index p = 0; p < static_cast<Index>(surface.Points.size()); ++p)
  {
    if (outgoing[p] != None)
    {
      EXPECT_EQ(rings.Constraints[p], BruteKind(brute, surface.Triangles, p)) << "point " << p;
    }
  }
}
}

TEST(EdgeMatching, NoTrianglesHaveNoEdges)
{
  const std::vector<Triangle> triangles;
  const EdgeMatching matching(triangles, 3);
  EXPECT_TRUE(matching.Twins().empty());
  EXPECT_EQ(matching.CountEdges().Edges, 0);
  EXPECT_EQ(matching.FindRings().Outgoing, LargeArray<Index>(3, None));
}

TEST(EdgeMatching, AgreesWithBruteForceOnAllShapes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    ExpectMatched(shape.Surface);
  }
}

TEST(EdgeMatching, RingsAgreeWithBruteForceWhereSomethingIsOdd)
{
  for (const Surface& surface : { PinchedVertex(6, 2), PinchedSolids(5), ThreeLeavedBook(3),
         MoebiusStrip(12, 2), InconsistentGrid(4), TetrahedronChain(3), Grid(4), Icosphere(1, 1.0),
         DuplicateTriangles(1, 5), Together(SingleTriangle(), Torus(6, 4)) })
  {
    ExpectRings(surface);
  }
}

TEST(EdgeMatching, AgreesWithBruteForceOnRandomSoups)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const Surface soup =
      RandomSoup(5 + static_cast<Index>(seed) / 3, 4 + 2 * static_cast<Index>(seed), seed);
    ExpectMatched(soup);
    ExpectRings(soup);
  }
}

TEST(EdgeMatching, ManyTrianglesAtOnePointAreMatchedLikeFew)
{
  // A cone and, twice, a fan of triangles in random order about its tip.
  Random random(4);
  Surface wheel;
  wheel.Points.resize(202);
  for (Index i = 0; i < 200; ++i)
  {
    wheel.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % 200 });
    wheel.Triangles.push_back({ 1 + random.Below(200), 0, 201 });
  }
  ExpectMatched(wheel);
}

TEST(EdgeMatching, TrianglesWithRepeatedCornersAreCounted)
{
  const std::vector<Triangle> triangles = { { 0, 0, 1 }, { 1, 2, 0 }, { 2, 2, 2 } };
  const EdgeCounts counts = EdgeMatching(triangles, 3).CountEdges();
  const BruteMatching brute(triangles);
  EXPECT_EQ(counts.Edges, brute.Counts.Edges);
  EXPECT_EQ(counts.Boundary, brute.Counts.Boundary);
  EXPECT_EQ(counts.NonManifold, brute.Counts.NonManifold);
}
