// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Demo.h
 * @brief bonedecimate demo: a first result, from a CT that the program makes itself.
 */
#ifndef BoneDecimate_Applications_Demo_h
#define BoneDecimate_Applications_Demo_h

#include <CLI/App.hpp>

namespace bonedecimate
{
void AddDemoCommand(CLI::App& program);
}

#endif
