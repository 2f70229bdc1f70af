// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GuardReach.h
 * @brief Distances that the intersection guard checks, in largest errors.
 */
#ifndef BoneDecimate_Core_Proof_Guard_GuardReach_h
#define BoneDecimate_Core_Proof_Guard_GuardReach_h

namespace bonedecimate
{
/// Both sides may move by the error, so a wider gap always keeps half of its width.
constexpr double ErrorsOfGap = 4.0;
/// Distance around edits within which the surface has to be known: both sides of a gap may move by
/// one error, and a thousandth is for rounding.
constexpr double ErrorsOfReach = ErrorsOfGap + 2.001;
}

#endif
