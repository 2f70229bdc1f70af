// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Workspace.h
 * @brief What one worker needs to change its part of a mesh: no two workers share one.
 */
#ifndef BoneDecimate_Core_Collapse_Workspace_h
#define BoneDecimate_Core_Collapse_Workspace_h

#include "Clearance/ClearanceGuard.h"
#include "Fragments.h"
#include "Guarantee/Prover.h"
#include "Kernels/Kernels.h"
#include "Levels/EditLog.h"
#include "Mesh/Neighbourhood.h"
#include "Report.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// Memory for the arrays of a fan; grows with the largest ring met and stays.
class FanStorage
{
public:
  /// The fan, with room for that many faces and a few lanes more.
  Fan& Reserve(int faces);
  Fan& Current() { return this->Arrays; }

private:
  Fan Arrays;
  std::vector<double> Numbers;
  std::vector<std::int64_t> Masks;
};

/// What a worker's edits amount to, until the editor takes it over.
struct Tally
{
  Fragments::Changes Volumes;
  std::array<std::int64_t, NumberOfVerdicts> Refusals{};
  std::int64_t Edits = 0;
  Index RemovedFaces = 0;
  std::vector<LoggedCollapse> Log; ///< Only where the run is recorded.
};

struct Workspace
{
  Neighbourhood Around; ///< What was examined last; Edge is None if that was refused.
  FanStorage Faces;     ///< The fan of the edit judged last.
  Tally Counted;
  VertexRange Range;              ///< What the worker may change.
  float Rank = 0.0F;              ///< What the next edit costs, for the log: see EditRecorder.h.
  std::shared_ptr<Prover> Proofs; ///< Lent where there is a guarantee.
  ClearanceGuard::Workspace Nearby;
};
}

#endif
