// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelValues.h
 * @brief Whether the values of voxels are intensities, as those of a CT, or names of parts.
 */
#ifndef BoneDecimate_Applications_VoxelValues_h
#define BoneDecimate_Applications_VoxelValues_h

#include "Volume.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate::volume
{
enum class ValueKind
{
  Intensities,
  Mask,  ///< 0 and one other whole number.
  Labels ///< A number for each part: an order or a value between two of them means nothing.
};

/**
 * Labels are whole numbers from 0 to 65535, at most 1,024 of them, at least two beside 0. Among
 * neighbors that are both not 0
 *
 *     most pairs are of equal numbers, for all labels together and for at least half of them each,
 *
 * which intensities are not: between tissues lie voxels of every value, and each tissue has noise.
 * Where a header says that the volume is a segmentation the neighbors do not count.
 */
class ValueSurvey
{
public:
  /// @param slab The volume, or the next slab of it (SlabReader.h).
  void Add(const Volume& slab);

  std::int64_t GetNumberOfNotFinite() const { return this->NotFinite; }
  double GetLeast() const { return this->Least; } ///< Least of the finite values.
  double GetLargest() const { return this->Largest; }

  /// Labels of a mask or a label map, ascending, without 0.
  std::vector<int> GetLabels() const;
  ValueKind GetKind() const;

private:
  /// Pairs of neighbors that have the label on one side and no 0 on the other.
  struct Pairs
  {
    std::int64_t Equal = 0;
    std::int64_t Different = 0;

    bool AreMostlyEqual() const { return this->Equal >= this->Different; }
  };

  template <typename Value>
  void AddValues(const Value* values, const std::array<vtkIdType, 3>& size, bool hasSharedLayer);
  template <typename Value>
  void FindRange(const Value* begin, const Value* end);
  template <typename Value>
  void FindLabels(const Value* begin, const Value* end);
  template <typename Value>
  void CountPairs(const Value* row, const Value* neighbors, vtkIdType count);
  bool HasRegions() const;

  std::int64_t NotFinite = 0;
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();
  bool MayBeLabels = true;
  bool IsSegmentation = false; ///< By its header.
  std::vector<bool> Occurs;    ///< For each label, whether it occurs.
  std::size_t Found = 0;       ///< Number of labels that occur, without 0.
  std::vector<Pairs> OfLabel;
};
}

#endif
