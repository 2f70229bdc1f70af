// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamePattern.h
 * @brief Names by a pattern as in a shell, whatever their case.
 */
#ifndef BoneDecimate_Applications_NamePattern_h
#define BoneDecimate_Applications_NamePattern_h

#include <string>

namespace bonedecimate
{
/// @param pattern With * and ?; where the system has fnmatch, with [abc], too.
bool MatchesPattern(const std::string& name, const std::string& pattern);
}

#endif
