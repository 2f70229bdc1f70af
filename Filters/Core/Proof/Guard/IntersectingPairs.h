// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntersectingPairs.h
 * @brief Counts the pairs of triangles of a surface that intersect, exactly (TrianglePair.h).
 */
#ifndef BoneDecimate_Core_Proof_Guard_IntersectingPairs_h
#define BoneDecimate_Core_Proof_Guard_IntersectingPairs_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"

#include <cstdint>
#include <optional>

namespace bonedecimate
{
/// @param surface Points with equal coordinates are merged; corners are valid.
/// @returns None after an abort.
std::optional<std::int64_t> CountIntersectingPairs(
  const Surface& surface, int threads, const Monitor& monitor = {});
}

#endif
