// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Trabeculae.h
 * @brief What a micro-CT would measure in a cube of trabecular bone, layer by layer.
 *
 * A gyroid, whose solid is a network of rods, with noise that makes rods thin out, break and grow
 * together to plates. The surface at 127.5 has about .03 triangles per voxel, so that 1,500 voxels
 * along each axis give 10^8.
 */
#ifndef BoneDecimate_Data_Trabeculae_h
#define BoneDecimate_Data_Trabeculae_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace phantom
{
class Trabeculae
{
public:
  /// @param size Voxels along each axis.
  explicit Trabeculae(int size);

  /// Appends the voxels of a layer: 0 in marrow, 255 in bone, some voxels of blur between them,
  /// noise.
  void AppendLayer(int k, std::vector<char>& bytes);

private:
  /// Noise of one size: a value for each node of a coarse grid, interpolated.
  struct NoiseLayer
  {
    int Step;        ///< Voxels between two nodes.
    double Strength; ///< Largest value.
    std::uint32_t Seed;
    std::vector<double> Nodes{}; ///< Nodes of the current row.
  };

  void AppendRow(int j, int k, std::vector<char>& bytes);
  void StartRow(NoiseLayer& layer, int j, int k) const;

  int Size;
  std::vector<double> Sines; ///< Sines of each coordinate.
  std::vector<double> Cosines;
  std::vector<NoiseLayer> NoiseLayers;
  std::vector<double> Row;
};
}

#endif
