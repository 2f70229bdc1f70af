// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ContinuedProof.h
 * @brief The certificate of a run that continues an earlier one (SurfacePart::Reference).
 *
 *     original -> result     of all triangles whose distance the run may have changed
 *     result -> original     of the triangles that the run has changed; all others are as they were
 */
#ifndef BoneDecimate_Core_Partition_Slabs_ContinuedProof_h
#define BoneDecimate_Core_Partition_Slabs_ContinuedProof_h

#include "Figures/DistanceFigures.h"
#include "Geometry/Surface.h"
#include "Options/Options.h"
#include "Proof/Certificate/Certificate.h"

#include <vector>

namespace bonedecimate
{
struct ContinuedRun
{
  const Surface& Original; ///< All of it that is within the largest error of what has changed.
  const Surface& Covered;  ///< The part of Original that the run may have uncovered.
  const Surface& Before;   ///< From which the run started.
  const Surface& After;
};

struct ContinuedProof
{
  ProofStatus Status = ProofStatus::Proved;
  ProvedDistance OriginalToResult; ///< mm
  ProvedDistance ResultToOriginal; ///< mm
  /// mm, of each point of the result, of the changed triangles around it;
  /// not a number if there are none.
  std::vector<double> Bounds;
};

/// @param options With the largest error.  @param withBounds Whether bounds of points are wanted.
ContinuedProof ProveContinued(
  const ContinuedRun& run, const Options& options, bool withBounds, const Monitor& monitor);
}

#endif
