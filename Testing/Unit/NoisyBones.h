// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NoisyBones.h
 * @brief Label maps and their surfaces, for tests of voxels.
 */
#ifndef BoneDecimate_Testing_NoisyBones_h
#define BoneDecimate_Testing_NoisyBones_h

#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Random.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
struct Map
{
  std::string Name;
  LabelMap Voxels;
};

/// A ball in a shell and a plate across both, with noise at the boundary.
inline LabelMap NoisyBones(const VoxelGrid& grid, double noise)
{
  Random random(7);
  LabelMap map = MakeLabelMap(grid.Dimensions,
    [&](const std::array<Index, 3>& voxel) -> int
    {
      const Vector3 p(voxel[0] - 7.0, voxel[1] - 6.0, voxel[2] - 6.0);
      const double r = p.norm() + noise * random.Between(-1.0, 1.0);
      return std::abs(p[2]) < 1.2 && r < 6.5 ? 7 : r < 2.6 ? 5 : r > 4.4 && r < 6.0 ? 2 : 0;
    });
  map.Grid = grid;
  return map;
}

inline VoxelGrid UnitGrid(const std::array<Index, 3>& size)
{
  VoxelGrid grid;
  grid.Dimensions = size;
  return grid;
}

inline LabelMap Binary(LabelMap map)
{
  for (std::int32_t& label : map.Labels)
  {
    label = label != 0 ? 1 : 0;
  }
  return map;
}

constexpr std::array<Index, 3> Size = { 15, 14, 13 };

inline std::vector<Map> Maps()
{
  return { { "Labels", NoisyBones(UnitGrid(Size), 0.0) },
    { "NoisyLabels", NoisyBones(UnitGrid(Size), 1.5) },
    { "ObliqueLabels", NoisyBones(ObliqueGrid(Size, false), 0.6) },
    { "MirroredBinary", Binary(NoisyBones(ObliqueGrid(Size, true), 0.6)) },
    { "Binary", Binary(NoisyBones(UnitGrid(Size), 0.4)) },
    { "ShearedLabels", NoisyBones(ShearedGrid(Size), 0.6) },
    { "UnevenBinary", Binary(NoisyBones(Uneven(UnitGrid(Size)), 0.6)) },
    { "UnevenShearedLabels", NoisyBones(Uneven(ShearedGrid(Size, true)), 0.4) },
    { "RandomLabels", NoiseLabels({ 6, 5, 6 }, 4, 3) } };
}

inline LabelSurfaces Extracted(const LabelMap& map, bool isClosed = true)
{
  LabelSurfaceOptions options;
  options.Closed = isClosed;
  return ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options);
}
}

#endif
