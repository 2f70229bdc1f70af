// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunProgress.h
 * @brief The monitor of a run cut into stages; remembers whether somebody asked to stop.
 */
#ifndef BoneDecimate_Core_RunProgress_h
#define BoneDecimate_Core_RunProgress_h

#include "Monitor.h"

namespace bonedecimate
{
class RunProgress
{
public:
  /// @param outer Must stay; may be empty.
  explicit RunProgress(const Monitor& outer)
    : Outer(outer)
  {
  }

  /// A monitor for one stage, whose 0 to 1 is a part of the whole. Once it said stop, it says so for ever.
  Monitor Stage(double from, double to)
  {
    return [this, from, to](double fraction)
    {
      this->Tell(from + fraction * (to - from));
      return this->Going;
    };
  }

  bool GoesOn() const { return this->Going; }

private:
  /// Stages may take a large step at once; who listens hears of every hundredth.
  void Tell(double fraction)
  {
    constexpr double hundredth = 0.01;
    while (this->Outer && this->Going && this->Told + hundredth < fraction)
    {
      this->Told += hundredth;
      this->Going = this->Outer(this->Told);
    }
    this->Told = fraction;
    this->Going = this->Going && (!this->Outer || this->Outer(fraction));
  }

  const Monitor& Outer;
  bool Going = true;
  double Told = 0.0;
};
}

#endif
