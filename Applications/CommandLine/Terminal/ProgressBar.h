// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProgressBar.h
 * @brief Shows the progress of an algorithm, which is aborted here after an interruption.
 */
#ifndef BoneDecimate_Applications_ProgressBar_h
#define BoneDecimate_Applications_ProgressBar_h

#include "ProgressDisplay.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

namespace bonedecimate
{
class ProgressBar : public vtkCommand
{
public:
  static ProgressBar* New() { return new ProgressBar; }
  vtkTypeMacro(ProgressBar, vtkCommand);

  /// @param display Null: nothing is shown.
  void SetDisplay(ProgressDisplay* display) { this->Display = display; }

  /// Tells the algorithm to abort once the program was interrupted.
  void Execute(vtkObject* caller, unsigned long event, void* callData) override;

private:
  ProgressDisplay* Display = nullptr;
};
}

#endif
