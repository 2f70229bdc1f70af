// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchOutput.h"

#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace bonedecimate
{
namespace
{
constexpr std::chrono::minutes ToldEvery(10);
}

BatchOutput::BatchOutput(const Arguments& arguments)
  : Quiet(arguments.Quiet)
  , Terminal(!arguments.Quiet && isatty(STDOUT_FILENO) == 1)
  , Lines(
      ProgressOf(arguments) == Progress::Lines && !(this->Terminal && isatty(STDERR_FILENO) == 1))
{
}

//------------------------------------------------------------------------------
void BatchOutput::Tell(const std::string& line) const
{
  if (this->Quiet)
  {
    return;
  }
  if (this->Terminal)
  {
    std::fputs("\r\033[K", stdout); // in place of the progress; the stream takes no such commands
  }
  std::cout << line << '\n' << std::flush;
}

//------------------------------------------------------------------------------
void BatchOutput::TellFailure(const std::string& line) const
{
  if (this->Quiet)
  {
    std::cerr << line << '\n';
  }
  this->Tell(line);
}

//------------------------------------------------------------------------------
void BatchOutput::Show(std::size_t ended, std::size_t all)
{
  if (ended == this->Shown)
  {
    return;
  }
  this->Shown = ended;
  const std::string text =
    std::to_string(ended) + " of " + std::to_string(all) + " inputs have ended";
  const auto now = std::chrono::steady_clock::now();
  if (this->Lines)
  {
    std::cerr << text << '\n';
  }
  if (this->Terminal)
  {
    std::cout << "\r" << text << std::flush;
  }
  else if (!this->Lines && now - this->Told > ToldEvery && ended < all)
  {
    this->Told = now;
    this->Tell(text);
  }
}
}
