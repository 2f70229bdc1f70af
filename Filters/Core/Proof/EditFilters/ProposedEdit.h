// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProposedEdit.h
 * @brief An edit that the rules of its kind allow, as the filters see it.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_ProposedEdit_h
#define BoneDecimate_Core_Proof_EditFilters_ProposedEdit_h

#include "Figures/Rejection.h"
#include "FragmentVolumes.h"
#include "JournalEntry.h"
#include "Levels/EditLog.h"
#include "Mesh/Edit.h"
#include "Mesh/VertexRange.h"
#include "SurfaceChange.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// What a worker's edits amount to until the editor settles it.
struct Tally
{
  FragmentVolumes Volumes;
  std::array<std::int64_t, NumberOfRejections> Rejections{};
  std::int64_t Edits = 0;
  Index RemovedFaces = 0;
  std::vector<LoggedCollapse> Log; ///< Only where the run is recorded.
  JournalPart Journal;             ///< Only in a draft.
};

struct ProposedEdit
{
  /// The edit; the first one if an edge is collapsed in several manifold patches.
  Edit Requested;
  VertexId Vertex;               ///< A vertex of the component that changes.
  double VolumeChange = 0.0;     ///< mm^3, of that component.
  FaceId OtherGoneFace;          ///< The other face that a collapse removes; None on a boundary.
  float Rank = 0.0F;             ///< Cost of a collapse, for the log (EditRecorder.h).
  double AccumulatedError = 0.0; ///< mm, of a collapse: the estimate of its schedule.
  VertexRange Range;             ///< What may be read and written.
  int Workers = 1;               ///< How many edit the mesh at the same time.
  const FragmentVolumes* Unsettled = nullptr; ///< Volumes of the worker that are not settled.
  SurfaceChange Change;                       ///< Filled only if a filter needs it.
};
}

#endif
