// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tally.h
 * @brief Counters and records of a worker that are not settled yet.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_Tally_h
#define BoneDecimate_Core_Proof_EditFilters_Tally_h

#include "Figures/Rejection.h"
#include "FragmentVolumes.h"
#include "JournalEntry.h"
#include "Levels/EditLog.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct Tally
{
  FragmentVolumes Volumes;
  std::array<std::int64_t, NumberOfRejections> Rejections{};
  std::int64_t Edits = 0;
  Index RemovedFaces = 0;
  std::vector<LoggedCollapse> Log; ///< Only where the run is recorded.
  JournalPart Journal;             ///< Only in a draft.
};
}

#endif
