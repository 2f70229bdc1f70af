// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of options for the scripts that generate code and panels in the build tree.
#include "Options/OptionTableJson.h"

#include <cstdio>
#include <string>

int main()
{
  const std::string text = bonedecimate::OptionTableJson();
  return std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0 ? 0 : 1;
}
