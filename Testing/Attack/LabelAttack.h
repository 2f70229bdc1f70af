// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelAttack.h
 * @brief Attacks smoothing and KeepVoxels with the surfaces of random label maps.
 *
 * Each run extracts the surfaces of a map, closed or open, and runs with random smoothing,
 * KeepVoxels, mode, error, tolerances, precision and threads. These must hold:
 *
 *     the result is within the error of the surface before smoothing         the certificate
 *     points of tolerance 0 and their triangles are there bit for bit
 *     no component, hole or wall is lost, label by label
 *     no new intersection with the guard, none by smoothing
 *     guarded, or only smoothed: no voxel changes (VoxelOracle.h, LabelMaps.h), none is nearer than
 *       the margin
 *     not guarded: VoxelCheck reports as many changed voxels as are counted here
 *     the same bytes with another number of threads
 */
#ifndef BoneDecimate_Testing_LabelAttack_h
#define BoneDecimate_Testing_LabelAttack_h

#include "AttackChecks.h"

#include <cstdint>
#include <string>

namespace bonedecimate::testsupport
{
/// Empty if there is no violation.
std::string AttackLabels(std::uint64_t seed, Totals& totals);
}

#endif
