// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <windows.h>

namespace
{
/// The console takes what is written for UTF-8, like the program's names and messages, and
/// afterwards for what it did before.
class Utf8Console
{
public:
  Utf8Console()
    : Before(GetConsoleOutputCP())
  {
    SetConsoleOutputCP(CP_UTF8);
  }

  ~Utf8Console() { SetConsoleOutputCP(this->Before); }

  Utf8Console(const Utf8Console&) = delete;
  void operator=(const Utf8Console&) = delete;

private:
  UINT Before;
};
}

int main(int argc, char* argv[])
{
  const Utf8Console console;
  return static_cast<int>(bonedecimate::RunProgram(argc, argv));
}
