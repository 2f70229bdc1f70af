// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressBar.h"

#include "Interruption.h"

namespace bonedecimate
{
void ProgressBar::Execute(vtkObject* caller, unsigned long, void* callData)
{
  if (IsInterrupted())
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
  if (this->Display != nullptr)
  {
    this->Display->Show(
      *static_cast<double*>(callData), this->Detail ? this->Detail() : std::string());
  }
}
}
