// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurrentFile.h
 * @brief Which of many files an IsolatedReader reads, for the message if it ends there.
 */
#ifndef BoneDecimate_Applications_CurrentFile_h
#define BoneDecimate_Applications_CurrentFile_h

#include <string>

namespace bonedecimate::volume
{
/// Of the reader, before it begins. Both processes see it from now on.
void ResetCurrentFile();

/// @param path Empty: none of many.
void SetCurrentFile(const std::string& path);

/// The name without its folder; empty: none of many.
std::string CurrentFile();

/// "its file IM0001.dcm is damaged or truncated: ..."
std::string DamagedFileProblem(const std::string& path);
}

#endif
