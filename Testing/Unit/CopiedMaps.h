// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CopiedMaps.h
 * @brief Label maps that were copied from coarser ones, as programs copy the result of a network.
 */
#ifndef BoneDecimate_Testing_CopiedMaps_h
#define BoneDecimate_Testing_CopiedMaps_h

#include "LabelMaps.h"
#include "Labels/ModelGrid/ModelGrid.h"
#include "Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
using Field = std::function<Index(const Vector3&)>;
using Voxel = std::array<Index, 3>;
using LayersOfAxis = std::vector<Index>;

inline std::uint64_t NumberFromEnvironment(const char* name, std::uint64_t otherwise)
{
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Seeds of the maps of each kind: BONEDECIMATE_MODEL_GRID_CASES of them, from
/// BONEDECIMATE_MODEL_GRID_FIRST on.
inline std::vector<std::uint64_t> SeedsOfMaps()
{
  std::vector<std::uint64_t> seeds(NumberFromEnvironment("BONEDECIMATE_MODEL_GRID_CASES", 6));
  std::iota(seeds.begin(), seeds.end(), NumberFromEnvironment("BONEDECIMATE_MODEL_GRID_FIRST", 0));
  return seeds;
}

inline LabelMap Sampled(const std::array<Index, 3>& size, const Field& labelAt)
{
  return MakeLabelMap(size,
    [&](const Voxel& v) {
      return labelAt({ 1.0 * v[0], 1.0 * v[1], 1.0 * v[2] });
    });
}

inline Index LabelAt(const LabelMap& map, const Voxel& v)
{
  const std::array<Index, 3>& size = map.Grid.Dimensions;
  return map.Labels[static_cast<std::size_t>((v[2] * size[1] + v[1]) * size[0] + v[0])];
}

/// Uneven bodies with a label each, where they overlap the nearest, in a box.
inline Field Bodies(Random& random, const Vector3& box, Index labels)
{
  struct Body
  {
    Vector3 Center;
    Vector3 Radii;
    Vector3 Waves;
  };
  std::vector<Body> bodies;
  const double radius = 0.5 * std::cbrt(box.prod() / labels);
  for (Index i = 0; i < labels; ++i)
  {
    Body body;
    for (int k = 0; k < 3; ++k)
    {
      const double ownRadius = std::min(radius, 0.45 * box[k]) * random.Between(0.7, 1.1);
      body.Radii[k] = ownRadius;
      body.Center[k] = random.Between(std::min(ownRadius, 0.5 * box[k]), box[k] - ownRadius);
      body.Waves[k] = random.Between(0.2, 0.6);
    }
    bodies.push_back(body);
  }
  return [bodies](const Vector3& p)
  {
    Index nearest = 0;
    double least = 1.0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      const Vector3 d = (p - bodies[i].Center).cwiseQuotient(bodies[i].Radii);
      const double waves = 0.1 * std::sin(p[0] * bodies[i].Waves[0]) +
        0.1 * std::sin(p[1] * bodies[i].Waves[1]) + 0.1 * std::sin(p[2] * bodies[i].Waves[2]);
      if (const double distance = d.norm() + waves; distance < least)
      {
        least = distance;
        nearest = static_cast<Index>(i) + 1;
      }
    }
    return nearest;
  };
}

/// The sample of each layer of a scan along an axis, as programs copy a map of that many samples.
struct CopiedAxis
{
  LayersOfAxis SampleOf;
  double Length = 1.0; ///< Layers per sample.
};

inline double Rounded(double x, bool toEven)
{
  return toEven ? std::nearbyint(x) : std::floor(x + 0.5);
}

inline CopiedAxis CopyAxis(Random& random, int convention, Index samples, double length)
{
  CopiedAxis axis;
  const auto layers = static_cast<Index>(std::lround(samples * length));
  const bool toEven = random.Uniform() < 0.5;
  const double shift = random.Uniform();
  axis.Length = convention == 0 ? (layers - 1.0) / (samples - 1.0)
    : convention == 1           ? 1.0 * layers / samples
                                : length;
  for (Index i = 0; i < layers; ++i)
  {
    const double position = convention == 0 ? i * (samples - 1.0) / (layers - 1.0)
      : convention == 1                     ? (i + 0.5) * samples / layers - 0.5
                                            : (i + shift) / length - 0.5;
    axis.SampleOf.push_back(
      std::clamp(static_cast<Index>(Rounded(position, toEven)), Index{ 0 }, samples - 1));
  }
  return axis;
}

/// Cuts off up to a fifth at each end.
inline void Crop(Random& random, CopiedAxis& axis)
{
  LayersOfAxis& all = axis.SampleOf;
  const auto fifth = static_cast<Index>(all.size() / 5);
  all = { all.begin() + random.Below(fifth), all.end() - random.Below(fifth) };
}

inline LabelMap Copy(const LabelMap& map, const std::array<CopiedAxis, 3>& axes)
{
  const auto layersOf = [&](std::size_t k) { return static_cast<Index>(axes[k].SampleOf.size()); };
  return MakeLabelMap({ layersOf(0), layersOf(1), layersOf(2) },
    [&](const Voxel& v)
    {
      Voxel sample;
      for (std::size_t k = 0; k < 3; ++k)
      {
        sample[k] = axes[k].SampleOf[static_cast<std::size_t>(v[k])];
      }
      return LabelAt(map, sample);
    });
}

inline ModelGrid FindIn(const LabelMap& map)
{
  return FindModelGrid(MakeLabelImage(map.Labels.data(), map.Grid));
}

struct Copied
{
  LabelMap Model;
  LabelMap File;
  std::array<CopiedAxis, 3> Axes;
  Index Labels;
};

/// @param convention 0: corners aligned; 1: centers aligned; 2: anywhere. Every third map is
///   cropped.
inline Copied MakeCopied(std::uint64_t seed, int convention)
{
  Random random(seed * 3 + static_cast<std::uint64_t>(convention) + 17);
  Copied copied;
  std::array<Index, 3> samples;
  std::array<double, 3> lengths;
  const bool isCropped = seed % 3 == 0;
  const double least = isCropped ? 1.3 : 1.2; // layers per sample
  const double length = random.Between(least, 4.0);
  const bool isIsotropic = random.Uniform() < 0.5;
  for (std::size_t k = 0; k < 3; ++k)
  {
    samples[k] = 30 + random.Below(40);
    lengths[k] = isIsotropic ? length : random.Between(least, 4.0);
  }
  copied.Labels = 1 + random.Below(random.Uniform() < 0.5 ? 5 : 120);
  copied.Model = Sampled(samples,
    Bodies(random, { 1.0 * samples[0], 1.0 * samples[1], 1.0 * samples[2] }, copied.Labels));
  for (std::size_t k = 0; k < 3; ++k)
  {
    copied.Axes[k] = CopyAxis(random, convention, samples[k], lengths[k]);
    if (isCropped)
    {
      Crop(random, copied.Axes[k]);
    }
  }
  copied.File = Copy(copied.Model, copied.Axes);
  return copied;
}

inline std::string Describe(const ModelGrid& found)
{
  std::string text = "chance " + std::to_string(std::log10(found.Chance)) + " different " +
    std::to_string(found.Different);
  for (const AxisCells& axis : found.Axes)
  {
    text += ", " + std::to_string(axis.Length) + " from " + std::to_string(axis.FirstSample) +
      " chance " + std::to_string(std::log10(axis.Chance));
  }
  return text;
}
}

#endif
