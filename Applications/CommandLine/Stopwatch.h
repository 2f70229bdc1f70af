// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stopwatch.h
 * @brief Seconds since it was made.
 */
#ifndef BoneDecimate_Applications_Stopwatch_h
#define BoneDecimate_Applications_Stopwatch_h

#include <chrono>

namespace bonedecimate
{
class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

#endif
