// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditWorkspace.h
 * @brief The data that a worker needs to check and apply edits. Every worker has its own.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_EditWorkspace_h
#define BoneDecimate_Core_Decimate_Edit_EditWorkspace_h

#include "Decimate/Kernels/Kernels.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Proof/EditFilters/EditFilter.h"
#include "Proof/EditFilters/SurfaceChange.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bonedecimate
{
/// Memory for the arrays of a fan. It grows to the largest fan.
class FanStorage
{
public:
  /// The fan, with capacity for that many faces and spare lanes.
  Fan& Reserve(int faces);
  Fan& Current() { return this->Arrays; }

private:
  Fan Arrays;
  std::vector<double> Numbers;
  std::vector<std::int64_t> Masks;
};

struct EditWorkspace
{
  EdgeNeighborhood Neighborhood; ///< That of the edge gathered last; Edge is None if rejected.
  FanStorage FanArrays;          ///< The fan of the edge gathered last.
  SurfaceChange Change;          ///< The change checked last, and the worker that proposes it.
  Tally Counts;
  /// Pending data of each filter; created for the first edit.
  std::vector<std::shared_ptr<EditFilter::Pending>> Pending;
};
}

#endif
