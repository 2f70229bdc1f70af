// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelRuns.h
 * @brief A label map as runs of equal labels along x, their neighbors, and which of them are
 * connected.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LabelRuns_h
#define BoneDecimate_Core_Labels_LabelMap_LabelRuns_h

#include "LabelImage.h"
#include "LabelRanks.h"

#include <cstddef>
#include <vector>

namespace bonedecimate
{
struct LabelRun
{
  Index Begin = 0; ///< Along x.
  Index End = 0;   ///< One past the last voxel.
  Index Rank = 0;  ///< Rank of the label.
  std::size_t Row = 0;
};

class LabelRuns
{
public:
  LabelRuns(const LabelImage& image, const LabelRanks& ranks);

  const std::vector<LabelRun>& All() const { return this->Runs; }
  std::size_t FirstVoxel(const LabelRun& run) const
  {
    return run.Row * this->Width + static_cast<std::size_t>(run.Begin);
  }
  static std::size_t Length(const LabelRun& run)
  {
    return static_cast<std::size_t>(run.End - run.Begin);
  }

  /// Volume of a run in voxels of the grid's spacing. The number of its voxels if layers have no
  /// positions of their own.
  double Amount(const LabelRun& run) const
  {
    return static_cast<double>(Length(run)) *
      (this->Thickness[run.Row / this->Height] / this->Spacing[2]);
  }

  /**
   * Calls visit(run, other, area) for the faces between two runs in mm^2, once for each pair of
   * rows, and visit(run, None, area) for those at the end of the image.
   */
  template <typename Visit>
  void VisitFaces(const Visit& visit) const;

  /// Joins runs of one rank, except 0, that have a face in common.
  /// @return For each run the first run of its piece.
  std::vector<std::size_t> JoinByFaces() const;

  /// Joins runs of rank 0 that have a face or an edge in common.
  std::vector<std::size_t> JoinByEdges() const;

  static constexpr std::size_t None = static_cast<std::size_t>(-1);

private:
  /// Calls visit(a, b) for runs of two rows that overlap, or are at most reach voxels apart along
  /// x.
  template <typename Visit>
  void VisitRows(std::size_t rowA, std::size_t rowB, Index reach, const Visit& visit) const
  {
    std::size_t b = this->FirstOfRow[rowB];
    for (std::size_t a = this->FirstOfRow[rowA]; a < this->FirstOfRow[rowA + 1]; ++a)
    {
      while (this->Runs[b].End + reach <= this->Runs[a].Begin)
      {
        ++b;
      }
      const Index end = this->Runs[a].End + reach;
      for (std::size_t c = b; c < this->FirstOfRow[rowB + 1] && this->Runs[c].Begin < end; ++c)
      {
        visit(a, c);
      }
    }
  }

  template <typename Visit>
  void VisitFacesBetween(
    std::size_t row, std::size_t before, bool isFirst, double area, const Visit& visit) const;

  std::size_t Width;
  std::size_t Height;
  std::size_t Depth;
  Vector3 Spacing;               // mm
  Vector3 Shear;                 // VoxelGrid::UnitArea()
  std::vector<double> Thickness; // of each layer, mm
  std::vector<LabelRun> Runs;
  std::vector<std::size_t> FirstOfRow; // and the end
};

/// @param isFirst Whether the row is at the end of the image and has none before it.
template <typename Visit>
void LabelRuns::VisitFacesBetween(
  std::size_t row, std::size_t before, bool isFirst, double area, const Visit& visit) const
{
  if (isFirst)
  {
    for (std::size_t a = this->FirstOfRow[row]; a < this->FirstOfRow[row + 1]; ++a)
    {
      visit(a, None, area * static_cast<double>(Length(this->Runs[a])));
    }
    return;
  }
  this->VisitRows(row, before, 0,
    [&](std::size_t a, std::size_t b)
    {
      const Index begin = std::max(this->Runs[a].Begin, this->Runs[b].Begin);
      const Index end = std::min(this->Runs[a].End, this->Runs[b].End);
      visit(a, b, area * (end - begin));
    });
}

template <typename Visit>
void LabelRuns::VisitFaces(const Visit& visit) const
{
  const double alongZ = this->Spacing[0] * this->Spacing[1] * this->Shear[2];
  for (std::size_t row = 0; row < this->Height * this->Depth; ++row)
  {
    const double thickness = this->Thickness[row / this->Height];
    const double alongX = this->Spacing[1] * thickness * this->Shear[0];
    const double alongY = this->Spacing[0] * thickness * this->Shear[1];
    const std::size_t last = this->FirstOfRow[row + 1] - 1;
    visit(this->FirstOfRow[row], None, alongX);
    for (std::size_t a = this->FirstOfRow[row]; a < last; ++a)
    {
      visit(a, a + 1, alongX);
    }
    visit(last, None, alongX);
    const std::size_t y = row % this->Height;
    const std::size_t z = row / this->Height;
    this->VisitFacesBetween(row, row - 1, y == 0, alongY, visit);
    this->VisitFacesBetween(row, row - this->Height, z == 0, alongZ, visit);
    if (y + 1 == this->Height)
    {
      this->VisitFacesBetween(row, row, true, alongY, visit);
    }
    if (z + 1 == this->Depth)
    {
      this->VisitFacesBetween(row, row, true, alongZ, visit);
    }
  }
}
}

#endif
