// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GuardedOptions.h
 * @brief Options of a run with an error bound, with and without the intersection guard.
 */
#ifndef BoneDecimate_Testing_GuardedOptions_h
#define BoneDecimate_Testing_GuardedOptions_h

#include "Runs.h"

namespace bonedecimate::testsupport
{
/// @param error mm
inline Options Guarded(Mode mode, double error, bool hasGuard = true)
{
  Options options = InMode(mode, Error(error));
  options.IntersectionGuard = hasGuard;
  return options;
}
}

#endif
