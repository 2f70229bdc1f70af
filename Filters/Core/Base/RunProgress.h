// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunProgress.h
 * @brief Divides the progress of a run into stages and stores whether the run was aborted.
 */
#ifndef BoneDecimate_Core_Base_RunProgress_h
#define BoneDecimate_Core_Base_RunProgress_h

#include "Monitor.h"

namespace bonedecimate
{
class RunProgress
{
public:
  /// @param outer Must outlive this; may be empty.
  explicit RunProgress(const Monitor& outer)
    : Outer(outer)
  {
  }

  /// A monitor for one stage, whose progress 0 to 1 maps to from-to. After an abort it always
  /// returns false.
  Monitor Stage(double from, double to)
  {
    return [this, from, to](double fraction)
    {
      this->Report(from + fraction * (to - from));
      return this->IsRunning;
    };
  }

  bool ShouldContinue() const { return this->IsRunning; }

private:
  /// Calls the outer monitor at every hundredth, even if a stage reports a larger step.
  void Report(double fraction)
  {
    constexpr double hundredth = 0.01;
    while (this->Outer && this->IsRunning && this->Reported + hundredth < fraction)
    {
      this->Reported += hundredth;
      this->IsRunning = this->Outer(this->Reported);
    }
    this->Reported = fraction;
    this->IsRunning = this->IsRunning && (!this->Outer || this->Outer(fraction));
  }

  const Monitor& Outer;
  bool IsRunning = true;
  double Reported = 0.0;
};
}

#endif
