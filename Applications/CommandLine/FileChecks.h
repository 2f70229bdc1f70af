// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileChecks.h
 * @brief Looks at a surface file before VTK does: VTK's readers trust counts, and read text as the
 * number 0.
 */
#ifndef BoneDecimate_Applications_FileChecks_h
#define BoneDecimate_Applications_FileChecks_h

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Existence, kind, size and permission of the file, then its format by its extension: announced
 * counts against what is there, numbers that are numbers, indices within range.
 * @returns Warnings, one line each.
 * @throws Failure(ExitCode::InputRefused) with one line.
 */
std::vector<std::string> CheckSurfaceFile(const std::string& path);

/// The part of it that holds for any file.
void CheckFile(const std::string& path);

/// @name One format each; the file is there and not empty. @{
void CheckObjFile(const std::string& path, std::vector<std::string>& warnings);
void CheckStlFile(const std::string& path);
void CheckPlyFile(const std::string& path, std::vector<std::string>& warnings);
void CheckVtpFile(const std::string& path);
void CheckVtkFile(const std::string& path);
/// @}

/// Throws the failure: "'NAME' was refused: REASON".
[[noreturn]] void Refuse(const std::string& path, const std::string& reason);

/// A text that may quote a damaged file: whatever is not printable ASCII becomes a question mark.
std::string PrintableText(std::string text);
}

#endif
