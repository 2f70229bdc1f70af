// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterProgress.h
 * @brief A filter as a monitor of the core.
 */
#ifndef FilterProgress_h
#define FilterProgress_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace bonedecimate
{
/// Reports the fraction that is done, 0 to 1. @returns False if the run is to be aborted.
inline bool GoesOn(vtkAlgorithm& filter, double fraction)
{
  filter.UpdateProgress(fraction);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220614)
  return !filter.CheckAbort();
#else
  return filter.GetAbortExecute() == 0;
#endif
}
}

#endif
