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

#include <chrono>

namespace bonedecimate
{
/// Whether a run of the filter is to go on. After an abort its output stays: it is valid.
inline bool ShouldContinue(vtkAlgorithm& filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220614)
  const bool isAborted = filter.CheckAbort();
#else
  const bool isAborted = filter.GetAbortExecute() != 0;
#endif
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (isAborted)
  {
    filter.SetAbortOutput(false);
  }
#endif
  return !isAborted;
}

/**
 * A progress event of the filter at every percent, and four times a second, so that an
 * observer can abort between two percents. Every call, of which there are many more, looks
 * whether the run is to be aborted.
 *
 *     FilterProgress progress(*this, "Comparing voxels");
 *     Run(..., std::ref(progress));
 */
class FilterProgress
{
public:
  /// @param text What the filter does, for GetProgressText().
  FilterProgress(vtkAlgorithm& filter, const char* text)
    : Filter(filter)
  {
    filter.SetProgressText(text);
  }
  FilterProgress(const FilterProgress&) = delete;
  FilterProgress& operator=(const FilterProgress&) = delete;

  /// @param fraction Done, 0 to 1. @returns False if the run is to be aborted.
  bool operator()(double fraction)
  {
    constexpr double rounding = 1e-9;
    const int percent = static_cast<int>(100.0 * fraction + rounding);
    bool shouldContinue = ShouldContinue(this->Filter);
    while (shouldContinue && this->Percent < percent)
    {
      ++this->Percent;
      shouldContinue = this->Tell();
    }
    constexpr std::chrono::milliseconds longest(250);
    return shouldContinue && Clock::now() - this->Told > longest ? this->Tell() : shouldContinue;
  }

private:
  using Clock = std::chrono::steady_clock;

  bool Tell()
  {
    this->Filter.UpdateProgress(this->Percent / 100.0);
    this->Told = Clock::now();
    return ShouldContinue(this->Filter);
  }

  vtkAlgorithm& Filter;
  int Percent = 0;
  Clock::time_point Told = Clock::now();
};
}

#endif
