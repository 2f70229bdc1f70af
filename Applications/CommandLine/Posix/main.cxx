// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

int main(int argc, char* argv[])
{
  return static_cast<int>(bonedecimate::RunProgram(argc, argv));
}
