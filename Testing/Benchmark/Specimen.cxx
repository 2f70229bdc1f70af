// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Specimen.h"

#include "Shapes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

namespace
{
using phantom::Point;

/// Lengths below are voxels.
constexpr double Wall = 3.0;
constexpr double BumpHeight = 2.5;
constexpr double BumpSize = 22.0;
constexpr double TrabeculaSize = 11.0;
constexpr double TrabeculaLevel = 0.12; ///< Above it a position belongs to a trabecula.

struct Bone
{
  Point Center;   ///< As fractions of the grid.
  Point HalfAxes; ///< As fractions of the grid.
};

constexpr std::array<Bone, 5> Bones = { {
  { { 0.30, 0.30, 0.50 }, { 0.23, 0.21, 0.45 } },
  { { 0.74, 0.27, 0.33 }, { 0.18, 0.20, 0.28 } },
  { { 0.72, 0.72, 0.40 }, { 0.22, 0.21, 0.35 } },
  { { 0.27, 0.76, 0.62 }, { 0.20, 0.18, 0.32 } },
  { { 0.74, 0.40, 0.80 }, { 0.20, 0.26, 0.14 } },
} };

Point Scaled(const Point& p, double factor)
{
  return { p.X * factor, p.Y * factor, p.Z * factor };
}

/// Voxels to the outside of the nearest bone before it gets its bumps.
double SmoothBones(const Point& p, double size)
{
  double nearest = size;
  for (const Bone& bone : Bones)
  {
    nearest = std::min(
      nearest, phantom::Ellipsoid(p, Scaled(bone.Center, size), Scaled(bone.HalfAxes, size)));
  }
  return nearest;
}

double Value(const Point& p, double size)
{
  double outside = SmoothBones(p, size);
  if (outside > 2.0 * BumpHeight)
  {
    return outside;
  }
  if (outside > -Wall - 2.0 * BumpHeight)
  {
    outside += BumpHeight * phantom::Noise(p, BumpSize, 11);
  }
  const double wall = std::max(outside, -outside - Wall);
  if (outside > -0.5 * Wall)
  {
    return wall;
  }
  const double trabecula =
    (TrabeculaLevel - phantom::Noise(p, TrabeculaSize, 23)) * 0.5 * TrabeculaSize;
  return std::min(wall, std::max(outside, trabecula));
}
}

void FillSpecimen(int size, float* values)
{
  std::atomic<int> next{ 0 };
  const auto fillSlices = [&]
  {
    for (int k = next++; k < size; k = next++)
    {
      float* value = values +
        static_cast<std::size_t>(k) * static_cast<std::size_t>(size) *
          static_cast<std::size_t>(size);
      for (int j = 0; j < size; ++j)
      {
        for (int i = 0; i < size; ++i)
        {
          *value++ = static_cast<float>(Value(
            { static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) }, size));
        }
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1U, std::thread::hardware_concurrency()); ++t)
  {
    threads.emplace_back(fillSlices);
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
}
