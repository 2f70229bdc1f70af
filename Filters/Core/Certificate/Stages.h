// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stages.h
 * @brief One monitor for stages of known shares, one after the other; once somebody said stop, so it stays.
 */
#ifndef BoneDecimate_Core_Certificate_Stages_h
#define BoneDecimate_Core_Certificate_Stages_h

#include "Monitor.h"

#include <algorithm>

namespace bonedecimate::certificate
{
class Stages
{
public:
  explicit Stages(const Monitor& outer)
    : Outer(outer)
  {
  }

  /// The monitor of the next stage, which takes this share of the whole.
  Monitor Next(double share)
  {
    const double from = this->Begun;
    this->Begun += share;
    return [this, from, share](double fraction) { return this->Tell(from + fraction * share); };
  }

  /// All is done.
  void Finish() { this->Tell(1.0); }

  bool GoesOn() const { return this->Going; }

private:
  bool Tell(double fraction)
  {
    this->Told = std::clamp(fraction, this->Told, 1.0);
    this->Going = this->Going && (!this->Outer || this->Outer(this->Told));
    return this->Going;
  }

  const Monitor& Outer;
  double Begun = 0.0;
  double Told = 0.0;
  bool Going = true;
};
}

#endif
