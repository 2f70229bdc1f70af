// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StageClock.h
 * @brief Measures the duration of a stage.
 */
#ifndef BoneDecimate_Core_Base_StageClock_h
#define BoneDecimate_Core_Base_StageClock_h

#include <chrono>

namespace bonedecimate
{
class StageClock
{
public:
  /// Time since construction, s.
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

#endif
