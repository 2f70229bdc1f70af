// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionProof.h
 * @brief The certificate of a part: of the triangles that changed and those that replace them, and
 * nothing else.
 *
 *     Certify(changed, new)                  surfaces; stronger than with the unchanged triangles
 *     Certify(part, result)                  boundaries, where the whole surface has some
 *     Certify(position, result)              the lower bound, which unchanged triangles may lower
 *     Certify(part, result)                  all of it, if the first one proves nothing
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionProof_h
#define BoneDecimate_Core_Partition_Regions_RegionProof_h

#include "RegionPart.h"

namespace bonedecimate
{
/// Fills in the proof in the report of the part's result and the bounds at points. After an abort
/// there is none.
/// @param part Its unchanged triangles are matched.
/// @param hasBoundaries Whether the whole surface has.
void ProvePart(
  const Options& options, bool hasBoundaries, const Monitor& monitor, RegionPart& part);
}

#endif
