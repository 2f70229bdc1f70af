// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionReport.h
 * @brief The report of the whole surface from those of its parts.
 *
 *     counts       of the input, plus what each part's result has more or less than the part
 *     distances    0 outside of the regions
 *     proof        a bound of each part is one of the whole, because the rest is the same
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionReport_h
#define BoneDecimate_Core_Partition_Regions_RegionReport_h

#include "JoinRegions.h"

namespace bonedecimate
{
/// Whether the parts' proofs are one of the whole, and each component keeps its sign and a quarter
/// of its volume.
bool ArePartsValid(const WholeSurface& whole, const RegionParts& parts,
  const std::map<Index, ExtentChange>& changes, bool wantsProof);

/// Fills in statistics, edits, distances and proof.  @param result Its surface and point distances
/// are filled.
void CombineReports(const WholeSurface& whole, const RegionParts& parts,
  const std::map<Index, ExtentChange>& changes, bool wantsProof, Result& result);

/// @param labels The labels of the input.
std::vector<LabelArea> AreasOfLabels(
  const WholeSurface& whole, const RegionParts& parts, const Labels& labels);
}

#endif
