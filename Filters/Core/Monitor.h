// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Monitor.h
 * @brief How a run tells its progress and hears that it should stop.
 */
#ifndef BoneDecimate_Core_Monitor_h
#define BoneDecimate_Core_Monitor_h

#include <functional>

namespace bonedecimate
{
/**
 * Called on the calling thread with the fraction done, 0 to 1, never decreasing, at least every 1 %.
 * Returns true to go on, false to abort: the run then ends with a valid surface.
 */
using Monitor = std::function<bool(double fraction)>;

/// The monitor of a stage whose 0 to 1 is a part of another's. That other one must stay, and must not be empty.
inline Monitor PartOf(const Monitor& monitor, double from, double to)
{
  return [&monitor, from, to](double done) { return monitor(from + done * (to - from)); };
}
}

#endif
