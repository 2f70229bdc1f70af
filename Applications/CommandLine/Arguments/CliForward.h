// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CliForward.h
 * @brief Declarations of CLI11's classes: including all of CLI11 costs a file four seconds of
 * compiling.
 */
#ifndef BoneDecimate_Applications_CliForward_h
#define BoneDecimate_Applications_CliForward_h

namespace CLI
{
class App;
class Option;
class Validator;
}

#endif
