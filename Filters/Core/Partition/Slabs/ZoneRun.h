// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ZoneRun.h
 * @brief Runs a slab together with the zone below it, where it continues earlier runs, within the
 * error of their common original.
 *
 *     strip        of the result so far, and the slab: all triangles within ZoneReach() of the zone
 *     original     all triangles within ZoneMargin() of the zone
 *     run          edits start from the strip; the bound refers to the
 *                  original  (SurfacePart::Reference)
 *     stay         points outside of the zone, points of finished
 *                  components, and all triangles at them
 *     proof        original near the zone -> new strip; changed triangles
 *                  -> original  (ContinuedProof.h)
 *
 * What changes lies in the zone. So the distance of anything that is more than the largest error
 * away from it is as proved before.
 */
#ifndef BoneDecimate_Core_Partition_Slabs_ZoneRun_h
#define BoneDecimate_Core_Partition_Slabs_ZoneRun_h

#include "Base/Monitor.h"
#include "Options/Options.h"
#include "Run/Input/RunInputs.h"
#include "Run/Output/Result.h"
#include "SurfacePiece.h"

namespace bonedecimate
{
/// mm, around the zone: the intersection guard looks four largest errors away, and both sides of a
/// gap may move by one.
double ZoneReach(double largestError);
double ZoneMargin(double largestError); ///< mm

struct ZoneInput
{
  SurfacePiece Original;
  SurfacePiece Strip;
  Zone EditZone;
  /// Edges of one triangle that do not reach it are where strip and original were cut. It may end
  /// ZoneMargin() outside of the edit zone.
  Zone BoundaryZone;
  std::vector<char> IsFinished; ///< Whether a point of the strip stays wherever it is.
};

struct ZoneResult
{
  /// Its surface is the new strip, of use if the status of the report is good.
  bonedecimate::Result Run;
  ProvedDistance OriginalToResult; ///< mm, of the original within the largest error of the zone.
  ProvedDistance ResultToOriginal; ///< mm, of the changed triangles.
  ProofStatus Proof{};
};

/// @param options With the largest error and without targets.
/// @param source Grid and labels; null: not known.
ZoneResult DecimateZone(const ZoneInput& input, const Options& options,
  const LabelMapSource* source, bool inputIsSingle, const Monitor& monitor);
}

#endif
