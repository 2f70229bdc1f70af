// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificatePairs.h
 * @brief Pairs of surfaces and brute-force distances to compare certificates with.
 */
#ifndef BoneDecimate_Testing_CertificatePairs_h
#define BoneDecimate_Testing_CertificatePairs_h

#include "BruteForce.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/Certificate/EdgeSides.h"
#include "Random.h"
#include "Shapes.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate::testsupport
{
/// Every point displaced at random by up to the amplitude, mm.
inline Surface Shaken(Surface surface, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  for (Vector3& point : surface.Points)
  {
    point += random.InCube(amplitude);
  }
  return surface;
}

inline certificate::EdgeSides SidesOf(const Surface& surface)
{
  return certificate::FindEdgeSides(surface.Points, surface.Triangles, 1);
}

struct NamedPair
{
  std::string Name;
  Surface Reference, Result;
};

/// Small pairs, some without area, with repeated triangles, of many parts, or with nothing in
/// common.
inline std::vector<NamedPair> SmallPairs()
{
  std::vector<NamedPair> pairs;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    const std::string name = std::to_string(seed);
    pairs.push_back(
      { "soups" + name, RandomSoup(9, 7, seed), Shaken(RandomSoup(8, 5, seed + 50), 0.2, seed) });
    pairs.push_back({ "shaken" + name, Icosphere(1, 5.0), Shaken(Icosphere(1, 5.0), 0.3, seed) });
  }
  pairs.push_back({ "coarser", Icosphere(2, 5.0), Icosphere(0, 5.0) });
  pairs.push_back({ "needles", Needles(5), Moved(Needles(4), { 0.003, 0.001, 0.5 }) });
  pairs.push_back({ "envelope", Envelope(), Moved(SingleTriangle(), { 0.3, 0.2, 0.1 }) });
  pairs.push_back({ "book", ThreeLeavedBook(2), Shaken(ThreeLeavedBook(1), 0.3, 9) });
  pairs.push_back({ "hole", HoledPlate(3), Grid(3) });
  Surface flat = Grid(2);
  flat.Triangles.push_back({ 0, 1, 2 }); // in a line
  flat.Triangles.push_back({ 4, 4, 4 });
  flat.Points.emplace_back(100.0, 0.0, 0.0); // of no triangle
  pairs.push_back({ "flat", flat, Moved(Grid(1), { 0.5, 0.25, 0.125 }) });
  Surface segment; // pieces of it have sides as short as rounding makes them
  segment.Points = { { -0.25, 1.0, -0.1875 }, { 2.5, 2.9375, 2.1875 } };
  segment.Triangles = { { 0, 1, 0 } };
  Surface near;
  near.Points = { { -0.3125, 0.375, -0.625 }, { 2.5, 2.9375, 2.1875 }, { -2.5, -1.625, -0.4375 },
    { -1.125, -1.1875, -1.75 }, { 2.3125, 1.4375, -0.8125 }, { -0.25, 1.0, -0.1875 },
    { -0.125, -1.3125, -1.75 }, { -1.6875, 2.0, -0.0625 } };
  near.Triangles = { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 1 } };
  pairs.push_back({ "segment", segment, near });
  return pairs;
}

/// Calls visit(position, weights) for (n + 1)(n + 2) / 2 positions spread over the triangle.
inline void ForEachSample(const Surface& surface, const Triangle& corners, int n,
  const std::function<void(const Vector3&, const std::array<double, 3>&)>& visit)
{
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      const std::array<double, 3> weights = { static_cast<double>(i) / n,
        static_cast<double>(j) / n, static_cast<double>(n - i - j) / n };
      visit(weights[0] * surface.Points[corners[0]] + weights[1] * surface.Points[corners[1]] +
          weights[2] * surface.Points[corners[2]],
        weights);
    }
  }
}

struct Sampled
{
  double Largest = 0.0; ///< mm
  double Reach = 0.0;   ///< mm, no point of the surface is farther from a sample
};

inline Sampled SampleDistance(const Surface& from, const Surface& to, int n)
{
  Sampled sampled;
  for (const Triangle& corners : from.Triangles)
  {
    ForEachSample(from, corners, n,
      [&](const Vector3& position, const auto&)
      { sampled.Largest = std::max(sampled.Largest, BruteNearest(to, position).Distance); });
    for (int side = 0; side < 3; ++side)
    {
      const double length =
        (from.Points[corners[side]] - from.Points[corners[(side + 1) % 3]]).norm();
      sampled.Reach = std::max(sampled.Reach, length / n);
    }
  }
  return sampled;
}
}

#endif
