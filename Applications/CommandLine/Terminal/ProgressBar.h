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

#include <functional>
#include <string>
#include <utility>

namespace bonedecimate
{
class ProgressBar : public vtkCommand
{
public:
  static ProgressBar* New() { return new ProgressBar; }
  vtkTypeMacro(ProgressBar, vtkCommand);

  /// @param display Null: nothing is shown.
  /// @param detail What it shows behind the fraction; may be empty.
  void SetDisplay(ProgressDisplay* display, std::function<std::string()> detail = {})
  {
    this->Display = display;
    this->Detail = std::move(detail);
  }

  /// Tells the algorithm to abort once the program was interrupted.
  void Execute(vtkObject* caller, unsigned long event, void* callData) override;

private:
  ProgressDisplay* Display = nullptr;
  std::function<std::string()> Detail;
};
}

#endif
