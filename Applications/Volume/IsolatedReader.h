// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IsolatedReader.h
 * @brief Reading in a child process, for libraries that do not survive every damaged file.
 *
 * VTK's XML reader follows null pointers, Debian's GDCM stops on assertions, and ITK's libraries trust
 * what a header announces. All write to the terminal, at times with pieces of the header in it.
 */
#ifndef BoneDecimate_Applications_IsolatedReader_h
#define BoneDecimate_Applications_IsolatedReader_h

#include "Volume.h"

#include <functional>

namespace bonedecimate::volume
{
/// What the reader returns, or a rejection if it does not return. Nothing it writes to the terminal
/// is seen.
Volume ReadIsolated(const std::function<Volume()>& read);
}

#endif
