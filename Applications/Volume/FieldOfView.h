// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FieldOfView.h
 * @brief The constant that scanners write outside of the circle that they measure, where no header
 * names it.
 */
#ifndef BoneDecimate_Applications_FieldOfView_h
#define BoneDecimate_Applications_FieldOfView_h

#include "Volume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/**
 * Above the value of a surface such a constant would be a wall of bone. It counts as padding if
 *
 *     all four corners of every layer have it,
 *     every voxel outside of a circle around the middle of the layers has it, and the circle fits
 *       into them,
 *     at least nine tenths of the voxels just inside of the circle have other values, which differ
 *       from each other.
 *
 * Voxels inside of the circle never change, whatever value they have; a layer without any other
 * value is padding as a whole.
 */
class FieldOfView
{
public:
  /// @param value Value of the surface.
  explicit FieldOfView(double value)
    : Value(value)
  {
  }

  /// @param slab The volume, or the next slab of it (SlabReader.h).
  void Add(const Volume& slab);

  /// After the last slab: whether there is padding above the value.
  bool HasPadding() const;

  /// Writes the least measured value to the padding of the volume or a slab.
  void Clear(const Volume& slab) const;

  /// Voxels that are padding.
  std::int64_t Count() const;

  /// What was cleared, for the user; empty if there is no padding.
  std::string Note() const;

  /// Why there is no surface inside of the circle; empty if there is one, or no padding.
  std::string Problem() const;

private:
  /// Voxels at about the same distance from the middle.
  struct Ring
  {
    std::int64_t Voxels = 0;
    std::int64_t Measured = 0; ///< Number of voxels whose value is not the constant.
    double Least = std::numeric_limits<double>::infinity();
    double Largest = -std::numeric_limits<double>::infinity();
  };

  void Begin(const Volume& slab);
  template <typename Scalar>
  void AddLayer(const Scalar* values);
  template <typename Scalar>
  void ClearLayer(Scalar* values) const;
  std::size_t RingAt(double distance) const
  {
    return static_cast<std::size_t>(distance / this->PixelSize);
  }
  double LeastMeasured() const;

  double Value;
  bool IsPossible = true;
  double Constant = 0.0;
  double PixelSize = 0.0;        ///< mm, the larger side.
  double LargestRadius = 0.0;    ///< mm, of a circle that fits in a layer.
  double Radius = 0.0;           ///< mm, of the measured voxel that is farthest from the middle.
  std::vector<double> Distances; ///< mm, of each voxel of a layer from the middle.
  std::array<vtkIdType, 2> Size{ { 0, 0 } };
  std::vector<Ring> Rings;
  std::int64_t Layers = 0;
  std::int64_t EmptyLayers = 0;
  std::int64_t NextLayer = 0;
};
}

#endif
