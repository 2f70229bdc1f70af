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
    : OuterMonitor(outer)
  {
  }

  /// The monitor of the next stage.
  /// @param weight Its part of the whole progress, 0 to 1.
  Monitor Next(double weight)
  {
    const double from = this->NextStart;
    this->NextStart += weight;
    return [this, from, weight](double fraction) { return this->Report(from + fraction * weight); };
  }

  /// Reports a progress of 1.
  void Finish() { this->Report(1.0); }

  bool ShouldContinue() const { return !this->IsAborted; }

private:
  bool Report(double fraction)
  {
    this->Reported = std::clamp(fraction, this->Reported, 1.0);
    this->IsAborted =
      this->IsAborted || (this->OuterMonitor && !this->OuterMonitor(this->Reported));
    return !this->IsAborted;
  }

  const Monitor& OuterMonitor;
  double NextStart = 0.0;
  double Reported = 0.0;
  bool IsAborted = false;
};
}

#endif
