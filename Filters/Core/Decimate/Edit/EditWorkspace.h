// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditWorkspace.h
 * @brief What one worker needs to change its part of a mesh. Every worker has its own.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_EditWorkspace_h
#define BoneDecimate_Core_Decimate_Edit_EditWorkspace_h

#include "Decimate/Kernels/Kernels.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Proof/EditFilters/EditFilter.h"
#include "Proof/EditFilters/ProposedEdit.h"

#include <memory>
#include <vector>

namespace bonedecimate
{
/// Memory for the arrays of a fan; grows with the largest ring met and stays.
class FanStorage
{
public:
  /// The fan, with capacity for that many faces and a few more lanes.
  Fan& Reserve(int faces);
  Fan& Current() { return this->Arrays; }

private:
  Fan Arrays;
  std::vector<double> Numbers;
  std::vector<std::int64_t> Masks;
};

struct Workspace
{
  EdgeNeighborhood Around; ///< Surroundings of the edge validated last; Edge is None if rejected.
  FanStorage Faces;        ///< The fan of the edge validated last.
  Tally Counted;
  VertexRange Range; ///< What the worker may change.
  float Rank = 0.0F; ///< The cost of the next collapse, for the log: see EditRecorder.h.
  double AccumulatedError = 0.0; ///< mm, of the next collapse, estimated: see DraftFilter.h.
  ProposedEdit Proposed;         ///< The edit that the filters see.
  /// Pending data of each filter; made for the first edit.
  std::vector<std::shared_ptr<EditFilter::Pending>> Pending;
};
}

#endif
