// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChangePieces.h
 * @brief Removes small islands and fills small cavities of a label map in memory.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_ChangePieces_h
#define BoneDecimate_Core_Labels_LabelMap_ChangePieces_h

#include "LabelPieces.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct PieceOptions
{
  std::vector<std::int64_t> Labels; ///< Labels to change; empty: all but the background.
  std::int64_t Background = 0;
  IslandLimits Islands;
  double CavityVolume = 0.0; ///< mm^3; larger cavities are kept. 0: off.
};

struct PieceCounts
{
  bool FitInt64 = true;                ///< Whether all labels do; if not, nothing changes.
  bool HoldsBackground = true;         ///< Whether the type of the labels does; the same.
  std::vector<SegmentPieces> Islands;  ///< By label, ascending; empty without a limit.
  std::vector<SegmentPieces> Cavities; ///< The same for cavities.
};

/**
 * Removes islands first, then fills cavities.
 * @param labels Changed; contiguous, x fastest, then y; as many as the grid has voxels.
 */
PieceCounts ChangePieces(
  const PieceOptions& options, void* labels, LabelType type, const VoxelGrid& grid);
}

#endif
