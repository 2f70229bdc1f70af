// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Monitor.h
 * @brief Callback for progress and abort of a run.
 */
#ifndef BoneDecimate_Core_Base_Monitor_h
#define BoneDecimate_Core_Base_Monitor_h

#include <functional>
#include <utility>

namespace bonedecimate
{
/**
 * Called on the calling thread with the fraction done, 0 to 1, never decreasing, at least at every
 * 1 %. Returns true to continue, false to abort: the run then ends with a valid surface.
 */
using Monitor = std::function<bool(double fraction)>;

/// Maps the progress 0 to 1 of the returned monitor to from-to of the given one, which must not be
/// empty.
inline Monitor PartOf(Monitor monitor, double from, double to)
{
  return [monitor = std::move(monitor), from, to](double done)
  { return monitor(from + done * (to - from)); };
}

/// PartOf() for one of `count` equal steps.
template <typename Number, typename Count>
Monitor StepOf(Monitor monitor, Number step, Count count)
{
  const auto steps = static_cast<double>(count);
  return PartOf(std::move(monitor), static_cast<double>(step) / steps,
    (static_cast<double>(step) + 1.0) / steps);
}
}

#endif
