// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stages.h
 * @brief Divides the progress of one monitor among consecutive stages. An abort ends all later
 * stages, too.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Stages_h
#define BoneDecimate_Core_Proof_Certificate_Stages_h

#include "Base/Monitor.h"

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

  /// The monitor of the next stage.  @param weight Its part of the whole progress, 0 to 1.
  Monitor Next(double weight)
  {
    const double from = this->Begun;
    this->Begun += weight;
    return [this, from, weight](double fraction) { return this->Tell(from + fraction * weight); };
  }

  /// Reports a progress of 1.
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
