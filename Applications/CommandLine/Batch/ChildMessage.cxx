// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include <algorithm>

namespace bonedecimate
{
std::string MessageIn(const std::string& errors)
{
  const std::string line = errors.substr(0, std::min(errors.find_first_of("\r\n"), errors.size()));
  const std::string program = "bonedecimate: ";
  return line.compare(0, program.size(), program) == 0 ? line.substr(program.size()) : line;
}
}
