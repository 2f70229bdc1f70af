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
/// Clears the name. Called before the reader begins; both processes see the names set from then on.
void ResetCurrentFile();

/// @param path Empty: the reader reads none of several files.
void SetCurrentFile(const std::string& path);

/// The name without its folder; empty: the reader reads none of several files.
std::string CurrentFile();

/// "its file IM0001.dcm is damaged or truncated: ..."
std::string DamagedFileProblem(const std::string& path);
}

#endif
