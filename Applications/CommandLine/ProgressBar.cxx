// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressBar.h"

#include "Interruption.h"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace bonedecimate
{
void ProgressBar::SetShown(bool shown)
{
  this->Shown = shown && isatty(STDOUT_FILENO) == 1;
}

void ProgressBar::Execute(vtkObject* caller, unsigned long, void* callData)
{
  if (IsInterrupted())
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
  const int percent = static_cast<int>(*static_cast<double*>(callData) * 100.0);
  if (!(this->Shown || this->Tags) || percent == this->Percent)
  {
    return;
  }
  this->Percent = percent;
  if (this->Tags)
  {
    std::printf("<filter-progress>%.2f</filter-progress>\n", percent / 100.0);
    std::fflush(stdout);
    return;
  }
  const auto done = static_cast<std::size_t>(percent < 0 ? 0 : (percent > 100 ? 50 : percent / 2));
  std::printf("\r[%s%s] %3d %%", std::string(done, '#').c_str(),
    std::string(50 - done, ' ').c_str(), percent);
  std::fflush(stdout);
}

void ProgressBar::Clear()
{
  if (this->Shown && !this->Tags && this->Percent >= 0)
  {
    std::printf("\r\033[K");
    std::fflush(stdout);
  }
  this->Percent = -1;
}
}
