// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProgressBar.h
 * @brief A bar on a terminal, nothing in a pipe, or 3D Slicer's tags. An interruption aborts the algorithm here.
 */
#ifndef BoneDecimate_Applications_ProgressBar_h
#define BoneDecimate_Applications_ProgressBar_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

namespace bonedecimate
{
class ProgressBar : public vtkCommand
{
public:
  static ProgressBar* New() { return new ProgressBar; }
  vtkTypeMacro(ProgressBar, vtkCommand);

  /// @param shown Whether to show it; it needs a terminal, too.
  void SetShown(bool shown);

  /// Tags instead of a bar, whatever the output is.
  void SetTags(bool tags) { this->Tags = tags; }

  /// Tells the algorithm to abort once the program was interrupted.
  void Execute(vtkObject* caller, unsigned long event, void* callData) override;

  /// Takes the bar away.
  void Clear();

private:
  bool Shown = false;
  bool Tags = false;
  int Percent = -1;
};
}

#endif
