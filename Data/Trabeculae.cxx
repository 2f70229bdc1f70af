// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trabeculae.h"

#include "Shapes.h"

namespace phantom
{
namespace
{
constexpr double Period = 290.0;    // voxels, of the gyroid
constexpr double Threshold = 0.60;  // of the gyroid, from -1.5 to 1.5, at the middle of the surface
constexpr double Contrast = 1600.0; // gray levels by which one unit of the gyroid differs
constexpr int NoiseLevels = 17;     // gray levels

/// A sine of parabolas, because libm's has not the same bytes on every system. @param at Periods,
/// not negative.
double Wave(double at)
{
  const double x = at - static_cast<double>(static_cast<std::int64_t>(at));
  return x < 0.5 ? 16.0 * x * (0.5 - x) : -16.0 * (x - 0.5) * (1.0 - x);
}

/// Weight of the second of two nodes.
double WeightAt(int voxel, int step)
{
  return Fade(static_cast<double>(voxel % step) / step, 0.0, 1.0);
}

/// Eight numbers of eight bits: the mixing function of SplitMix64 (G. Steele, 2014).
std::uint64_t Mixed(std::uint64_t number)
{
  number += 0x9e3779b97f4a7c15ULL;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebULL;
  return number ^ (number >> 31U);
}
}

Trabeculae::Trabeculae(int size)
  : Size(size)
  , NoiseLayers{ { 150, 0.5, 51 }, { 37, 0.2, 52 } }
  , Row(static_cast<std::size_t>(size))
{
  for (int i = 0; i < size; ++i)
  {
    this->Sines.push_back(Wave(i / Period));
    this->Cosines.push_back(Wave(i / Period + 0.25));
  }
}

void Trabeculae::AppendLayer(int k, std::vector<char>& bytes)
{
  for (int j = 0; j < this->Size; ++j)
  {
    this->AppendRow(j, k, bytes);
  }
}

void Trabeculae::StartRow(NoiseLayer& layer, int j, int k) const
{
  const int step = layer.Step;
  const double v = WeightAt(j, step);
  const double w = WeightAt(k, step);
  layer.Nodes.clear();
  for (int node = 0; node <= this->Size / step + 1; ++node)
  {
    const auto at = [&](int dj, int dk)
    { return Hash(node, j / step + dj, k / step + dk, layer.Seed); };
    const double lower = at(0, 0) + v * (at(1, 0) - at(0, 0));
    const double upper = at(0, 1) + v * (at(1, 1) - at(0, 1));
    layer.Nodes.push_back(layer.Strength * (lower + w * (upper - lower)));
  }
}

void Trabeculae::AppendRow(int j, int k, std::vector<char>& bytes)
{
  const auto y = static_cast<std::size_t>(j);
  const auto z = static_cast<std::size_t>(k);
  const std::size_t size = this->Row.size();
  for (std::size_t x = 0; x < size; ++x)
  {
    this->Row[x] = this->Sines[x] * this->Cosines[y] + this->Sines[y] * this->Cosines[z] +
      this->Sines[z] * this->Cosines[x] - Threshold;
  }
  for (NoiseLayer& layer : this->NoiseLayers)
  {
    this->StartRow(layer, j, k);
    const auto step = static_cast<std::size_t>(layer.Step);
    for (std::size_t x = 0; x < size; ++x)
    {
      const double* node = layer.Nodes.data() + x / step;
      this->Row[x] += node[0] + WeightAt(static_cast<int>(x), layer.Step) * (node[1] - node[0]);
    }
  }
  std::uint64_t noise = 0;
  for (std::size_t x = 0; x < size; ++x)
  {
    noise = x % 8 == 0 ? Mixed((z * size + y) * size + x) : noise >> 8U;
    const int level = static_cast<int>(noise & 0xffU) * NoiseLevels / 256 - NoiseLevels / 2;
    bytes.push_back(static_cast<char>(
      static_cast<int>(Clamped(128.0 + Contrast * this->Row[x] + level, 0.0, 255.0))));
  }
}
}
