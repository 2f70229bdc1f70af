// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The steps of the proof with random triangles: every proved bound holds point by point.
#include "BruteForce.h"
#include "Proof/ErrorBound/CommonFaceProof.h"
#include "Proof/ErrorBound/ErrorBound.h"
#include "Proof/ErrorBound/FaceProof.h"
#include "Proof/ErrorBound/PlaneCover.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A triangle of random size near the origin.
std::array<Vector3, 3> AnyTriangle(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  std::array<Vector3, 3> triangle;
  for (Vector3& corner : triangle)
  {
    corner = Vector3(uniform(random), uniform(random), 0.3 * uniform(random));
  }
  return triangle;
}

Vector3 AnyPoint(std::mt19937& random, const std::array<Vector3, 3>& triangle)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double b = uniform(random);
  double c = uniform(random);
  if (b + c > 1.0)
  {
    b = 1.0 - b;
    c = 1.0 - c;
  }
  return triangle[0] + b * (triangle[1] - triangle[0]) + c * (triangle[2] - triangle[0]);
}
}

TEST(CommonFaceProof, NeverProvesAFalseBound)
{
  std::mt19937 random(7);
  int proved = 0;
  for (int round = 0; round < 2000; ++round)
  {
    Surface candidates;
    CommonFaceProof proof;
    for (Index i = 0; i < 4; ++i)
    {
      const std::array<Vector3, 3> triangle = AnyTriangle(random, 2.0);
      proof.AddCandidate(triangle);
      candidates.Points.insert(candidates.Points.end(), triangle.begin(), triangle.end());
      candidates.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    const std::array<Vector3, 3> triangle = AnyTriangle(random, 1.0);
    const double limit = 0.6;
    CommonFaceProof::Piece whole;
    for (std::size_t k = 0; k < 3; ++k)
    {
      whole[k] = { triangle[k], limit, proof.FacesNear(triangle[k], limit) };
    }
    CommonFaceProof::Faces used = 0;
    if (proof.Prove(whole, used, 256) == CommonFaceResult::Proved)
    {
      ++proved;
      for (int i = 0; i < 50; ++i)
      {
        const Vector3 p = AnyPoint(random, triangle);
        EXPECT_LE(BruteNearest(candidates, p).Distance, limit * (1.0 + 1e-12));
      }
    }
  }
  EXPECT_GT(proved, 200);
}

TEST(PlaneCover, NeverProvesAFalseBound)
{
  const Surface surface = BumpySphere(3, 5.0, 0.2, 7);
  const HalfEdgeMesh mesh(surface);
  PlaneCover cover(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int proved = 0;
  for (int round = 0; round < 3000; ++round)
  {
    const Index seed = static_cast<Index>(random() % surface.Triangles.size());
    const Vector3 middle = surface.Points[surface.Triangles[seed][0]];
    std::array<Vector3, 3> face;
    for (Vector3& corner : face)
    {
      corner = middle + Vector3(uniform(random), uniform(random), uniform(random));
    }
    const double limit = 0.7;
    if (cover.Prove(face, seed, [limit](Index) { return limit; }))
    {
      ++proved;
      for (int i = 0; i < 50; ++i)
      {
        EXPECT_LE(BruteNearest(surface, AnyPoint(random, face)).Distance, limit * (1.0 + 1e-12));
      }
    }
  }
  EXPECT_GT(proved, 50);
}

TEST(CommonFaceProof, EvaluatesNoCandidateBeyondItsLimit)
{
  const std::array<Vector3, 3> face = { Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0) };
  for (const double most : { 0.2, 0.4 })
  {
    CommonFaceProof proof;
    proof.AddCandidate(face, most);
    CommonFaceProof::Piece whole;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3 p = 0.5 * face[k] + Vector3(0.5, 0.5, 0.3);
      whole[k] = { p, 1.0, proof.FacesNear(p, 1.0) };
    }
    CommonFaceProof::Faces used = 0;
    EXPECT_EQ(proof.Prove(whole, used, 256),
      most > 0.3 ? CommonFaceResult::Proved : CommonFaceResult::TooFar);
  }
}

namespace
{
/// Half of the corners are points of the surface, moved a little.
std::array<Vector3, 3> AnyFaceNear(const Surface& surface, std::mt19937& random, double away)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto anyVector = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
  const Vector3 middle = surface.Points[random() % surface.Points.size()];
  std::array<Vector3, 3> face;
  for (Vector3& corner : face)
  {
    corner = middle + anyVector();
    const bool isOnIt = random() % 2 == 0;
    const Index nearest = BruteNearestPoint(surface, corner);
    corner = isOnIt ? Vector3(surface.Points[static_cast<std::size_t>(nearest)]) : corner;
    corner += away * anyVector();
  }
  return face;
}

/// mm, the largest distance of many points of the face.
double FarthestSample(const Surface& surface, const std::array<Vector3, 3>& face)
{
  constexpr int steps = 6;
  double farthest = 0.0;
  for (int b = 0; b <= steps; ++b)
  {
    for (int c = 0; b + c <= steps; ++c)
    {
      const Vector3 p =
        face[0] + (b * (face[1] - face[0]) + c * (face[2] - face[0])) / static_cast<double>(steps);
      farthest = std::max(farthest, BruteNearest(surface, p).Distance);
    }
  }
  return farthest;
}

/// Closed and bumpy, with rims thinner than the limit, with a boundary.
std::vector<Surface> SurfacesForFaces()
{
  return { BumpySphere(3, 5.0, 0.2, 7), Scaled(FlatPlate(12), 0.2), HeightField(14, 0.3, 3) };
}
}

TEST(FaceProof, NeverProvesAFalseBoundAndProvesMostTrueOnes)
{
  for (const Surface& surface : SurfacesForFaces())
  {
    const HalfEdgeMesh mesh(surface);
    const BoundingTree tree(surface);
    const double limit = 0.25;
    ErrorBoundSettings settings;
    settings.Error = limit;
    const ErrorLimits limits(mesh, settings);
    const WalkedSurface target(mesh, tree, limits);
    FaceProof proof(mesh);
    std::mt19937 random(5);
    int proved = 0;
    int provable = 0;
    int notProved = 0;
    for (int round = 0; round < 200; ++round)
    {
      const std::array<Vector3, 3> face = AnyFaceNear(surface, random, 0.1);
      const double farthest = FarthestSample(surface, face);
      const bool isProved = proof.Prove(target, face, tree.FindNearest(face[0]).Triangle);
      EXPECT_TRUE(!isProved || farthest <= limit * (1.0 + 1e-12)) << farthest;
      proved += isProved ? 1 : 0;
      provable += farthest < 0.9 * limit ? 1 : 0;
      notProved += farthest < 0.9 * limit && !isProved ? 1 : 0;
    }
    EXPECT_GT(proved, 20);
    EXPECT_LT(notProved, 0.2 * provable);
  }
}

TEST(FaceProof, ProvesFacesThatReachBeyondABoundary)
{
  const Surface surface = Grid(4);
  const HalfEdgeMesh mesh(surface);
  const BoundingTree tree(surface);
  ErrorBoundSettings settings;
  settings.Error = 0.3;
  const ErrorLimits limits(mesh, settings);
  FaceProof proof(mesh);
  for (const double beyond : { 0.0, 0.2, 0.4 })
  {
    const std::array<Vector3, 3> face = { Vector3(-beyond, 0.3, 0.1), Vector3(3.1, 2.0, 0.0),
      Vector3(-beyond, 3.7, -0.1) };
    EXPECT_EQ(proof.Prove({ mesh, tree, limits }, face, 0), beyond < 0.3) << beyond;
  }
}

TEST(ErrorBoundSettings, RoundsToWhatSinglePrecisionHolds)
{
  ErrorBoundSettings settings;
  settings.Rounding.ToSingle = true;
  settings.Origin = Vector3(5000.1, -3000.2, 700.3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 40.0);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 p(uniform(random), uniform(random), uniform(random));
    const Vector3 written = settings.Rounded(p) + settings.Origin;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const volatile float single = static_cast<float>(written[axis]);
      EXPECT_NEAR(written[axis], static_cast<double>(single), 1e-11);
    }
    EXPECT_LT((settings.Rounded(p) - p).norm(), 1e-3);
  }
}

TEST(CommonFaceProof, ProvesATriangleOverManyFacesInFewPieces)
{
  constexpr double limit = 0.1; // much smaller than the faces
  CommonFaceProof proof;
  for (int i = 0; i < 7; ++i)
  {
    const auto rim = [](int at)
    { return Vector3(2.0 * std::cos(0.9 * at), 2.0 * std::sin(0.9 * at), 0.02 * (at % 3)); };
    proof.AddCandidate({ Vector3(0.05, 0.02, 0.03), rim(i), rim(i + 1) });
  }
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 200; ++round)
  {
    CommonFaceProof::Piece whole;
    for (CommonFaceProof::Corner& corner : whole)
    {
      const Vector3 p(uniform(random), uniform(random), 0.0);
      corner = { p, limit, proof.FacesNear(p, limit) };
    }
    CommonFaceProof::Faces used = 0;
    EXPECT_EQ(proof.Prove(whole, used, 256), CommonFaceResult::Proved) << round;
  }
}
