// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearAttack.h
 * @brief Whether parts of a surface that are nearer to each other than the largest error pass
 * through each other.
 *
 *     rings:       the linking number of a loop of edges around each, by Gauss's integral, is that
 *                  of the input
 *     components:  each is inside of the same others as in the input, by winding numbers, and none
 *                  is turned inside out
 *     plates:      rays from one meet those that are above or below it in the input
 *     all:         no more pairs of triangles pierce each other; topology, error bound and
 *                  boundaries as in other attacks
 *
 * The linking number of two rings does not depend on the loops: none of these is within the tube of
 * the other. That of two handles is that of loops which wind once around their own axis and not
 * around the other one.
 */
#ifndef BoneDecimate_Testing_NearAttack_h
#define BoneDecimate_Testing_NearAttack_h

#include "AttackChecks.h"

#include <cstdint>
#include <string>

namespace bonedecimate::testsupport
{
/// Empty if there is no violation.
std::string AttackNear(std::uint64_t seed, Totals& totals);
}

#endif
