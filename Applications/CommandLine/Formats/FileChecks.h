// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileChecks.h
 * @brief What holds for any file that is read, and a look at VTK's own formats before VTK's readers
 * trust their counts.
 */
#ifndef BoneDecimate_Applications_FileChecks_h
#define BoneDecimate_Applications_FileChecks_h

#include <string>

namespace bonedecimate
{
class CoordinateCollector;

/// Existence, kind, size and permission of a file. @throws Failure(ExitCode::InputRejected)
void CheckFile(const std::string& path);

/**
 * @name Announced counts against what is there; the file is there and not empty.
 * @param textPoints Gets the coordinates if they are text: an array of single precision, which VTK
 * makes of them, may round them.
 * @{
 */
void CheckVtpFile(const std::string& path, CoordinateCollector& textPoints);
void CheckVtkFile(const std::string& path, CoordinateCollector& textPoints);
/// @}

/// Throws the failure: "'NAME' was rejected: REASON".
[[noreturn]] void Reject(const std::string& path, const std::string& reason);

/// A text that may quote a damaged file: whatever is not printable ASCII becomes a question mark.
std::string PrintableText(std::string text);
}

#endif
