// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// No grid of a network is claimed of maps that were made at the resolution of the file.
#include "CopiedMaps.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The size and the position of what a map shows.
struct Scene
{
  explicit Scene(std::uint64_t seed)
    : Source(seed + 1000)
    , Seed(seed)
  {
    this->Size = { this->Whole(40, 100), this->Whole(40, 100), this->Whole(40, 100) };
    this->Box = Vector3(1.0 * this->Size[0], 1.0 * this->Size[1], 1.0 * this->Size[2]);
    this->Middle = 0.5 * this->Box + this->Source.InCube(3.0);
    this->Radius = 0.45 * this->Box.minCoeff() * this->Source.Between(0.5, 1.0);
    if (this->Is(2)) // voxel centers
    {
      this->Middle = this->Middle.array().round();
      this->Radius = std::floor(this->Radius);
    }
  }

  Index Whole(Index least, Index end) { return least + this->Source.Below(end - least); }
  bool Is(std::uint64_t multiple) const { return this->Seed % multiple == 0; }

  Random Source;
  std::uint64_t Seed;
  Voxel Size;
  Vector3 Box;
  Vector3 Middle;
  double Radius;
};

Index At(double position, Index width)
{
  return static_cast<Index>(position) / width;
}

Field BodiesOf(Scene& scene)
{
  return Bodies(scene.Source, scene.Box, scene.Whole(1, scene.Is(2) ? 6 : 60));
}

Field Ball(Scene& scene)
{
  return [scene](const Vector3& p) { return (p - scene.Middle).norm() <= scene.Radius ? 1 : 0; };
}

Field Ellipsoids(Scene& scene)
{
  const Vector3 radii =
    scene.Radius * Vector3(1.0, scene.Source.Between(0.1, 1.0), scene.Source.Between(0.1, 1.0));
  return [scene, radii](const Vector3& p)
  {
    const double distance = (p - scene.Middle).cwiseQuotient(radii).norm();
    return distance < 0.5 ? 2 : distance < 1.0 ? 1 : 0;
  };
}

/// Boxes of whole steps at whole steps.
Field Boxes(Scene& scene)
{
  const Index step = scene.Whole(1, 9);
  struct Block
  {
    Vector3 Low;
    Vector3 High;
  };
  std::vector<Block> blocks(static_cast<std::size_t>(scene.Whole(1, 41)));
  for (Block& block : blocks)
  {
    const Vector3 low = 0.5 * scene.Box + 0.45 * scene.Source.InCube(1.0).cwiseProduct(scene.Box);
    block.Low = (low / step).array().floor() * step;
    block.High = block.Low + Vector3::Constant(scene.Whole(2, 7) * step);
  }
  return [blocks](const Vector3& p)
  {
    const auto found = std::find_if(blocks.begin(), blocks.end(),
      [&](const Block& block)
      { return (p.array() >= block.Low.array()).all() && (p.array() < block.High.array()).all(); });
    return static_cast<Index>(blocks.end() - found);
  };
}

Field Cylinders(Scene& scene)
{
  const double slope = scene.Is(3) ? 0.0 : 1.0 / scene.Whole(1, 10);
  return [scene, slope](const Vector3& p)
  {
    const Vector3 d = p - scene.Middle;
    const double distance = std::hypot(d[0] - slope * d[2], d[1]);
    return distance > scene.Radius || std::abs(d[2]) > scene.Radius ? 0
      : distance < 0.5 * scene.Radius                               ? 2
                                                                    : 1;
  };
}

Field Bars(Scene& scene)
{
  const Index width = scene.Whole(1, 9);
  const Index axis = scene.Whole(0, 3);
  return [scene, width, axis](const Vector3& p)
  {
    const bool isInside = ((p - scene.Middle).cwiseAbs().array() < scene.Radius).all();
    return isInside && At(p[axis], width) % 2 == 0 ? 1 : 0;
  };
}

Field Checkers(Scene& scene)
{
  const Index width = scene.Whole(2, 10);
  return [width](const Vector3& p)
  { return (At(p[0], width) + At(p[1], width) + At(p[2], width)) % 2; };
}

/// A pyramid or a wedge.
Field Steps(Scene& scene)
{
  const Index width = scene.Whole(2, 11);
  return [scene, width](const Vector3& p)
  {
    const Index level = At(p[2], width);
    const double reach = scene.Radius - 0.5 * level * width;
    const bool isInPyramid = ((p - scene.Middle).head<2>().cwiseAbs().array() < reach).all();
    return (scene.Is(2) ? isInPyramid : At(p[0], width) > level) ? 1 : 0;
  };
}

Field Planes(Scene& scene)
{
  const Vector3 normal(scene.Source.Uniform(), scene.Is(2) ? 0.0 : scene.Source.Uniform(), 1.0);
  const double slope = scene.Source.Uniform();
  return [scene, normal, slope](const Vector3& p)
  {
    const Vector3 d = p - scene.Middle;
    return Dot(normal, d) < 0.0 ? 1 : d[1] > slope * d[2] ? 2 : 0;
  };
}

Field Noise(Scene& scene)
{
  const LabelMap noise = NoiseLabels(scene.Size, scene.Whole(2, 10), scene.Seed);
  return [noise](const Vector3& p)
  {
    return LabelAt(
      noise, { static_cast<Index>(p[0]), static_cast<Index>(p[1]), static_cast<Index>(p[2]) });
  };
}

/// A single layer, along any axis, of a copied map.
Field Slice(Scene& scene)
{
  const Field bodies = Bodies(scene.Source, scene.Box, scene.Whole(1, 10));
  const double length = scene.Source.Between(1.0, 3.0);
  const Index axis = scene.Whole(0, 3);
  const double middle = 0.5 * scene.Box[axis];
  scene.Size[static_cast<std::size_t>(axis)] = 1;
  return [bodies, length, axis, middle](const Vector3& p)
  {
    Vector3 sample = (p / length).array().floor() * length;
    sample[axis] = middle;
    return bodies(sample);
  };
}

struct Kind
{
  const char* Name;
  Field (*FieldOf)(Scene& scene);
};

class OtherMaps : public testing::TestWithParam<Kind>
{
};
}

TEST_P(OtherMaps, HaveNoGridOfANetwork)
{
  for (const std::uint64_t seed : SeedsOfMaps())
  {
    Scene scene(seed);
    const Field field = this->GetParam().FieldOf(scene);
    const ModelGrid found = FindIn(Sampled(scene.Size, field));
    EXPECT_FALSE(found.IsFound) << "seed " << seed << "; " << Describe(found);
  }
}

INSTANTIATE_TEST_SUITE_P(ModelGrid, OtherMaps,
  testing::Values(Kind{ "Bodies", BodiesOf }, Kind{ "Ball", Ball },
    Kind{ "Ellipsoids", Ellipsoids }, Kind{ "Boxes", Boxes }, Kind{ "Cylinders", Cylinders },
    Kind{ "Bars", Bars }, Kind{ "Checkers", Checkers }, Kind{ "Steps", Steps },
    Kind{ "Planes", Planes }, Kind{ "Noise", Noise }, Kind{ "Slice", Slice }),
  [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.Name); });
