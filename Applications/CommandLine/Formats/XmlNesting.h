// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file XmlNesting.h
 * @brief How deeply the elements of a VTK XML file are nested, and how many arrays it has: VTK's
 * reader calls itself for each level, and compares the name of each array with those of all others.
 */
#ifndef BoneDecimate_Applications_XmlNesting_h
#define BoneDecimate_Applications_XmlNesting_h

#include <string>

namespace bonedecimate
{
/// Reads the tags before appended data. @throws Failure(ExitCode::InputRejected) for depths and
/// counts that no such file needs.
void CheckNesting(const std::string& path);
}

#endif
