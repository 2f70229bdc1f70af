// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedPipe.h
 * @brief Whether a pipe has no reader any more, as that of `bonedecimate --help | head`.
 */
#ifndef BoneDecimate_Applications_ClosedPipe_h
#define BoneDecimate_Applications_ClosedPipe_h

#include <cerrno>

namespace bonedecimate
{
/// @param error The errno of the write that failed.
inline bool IsClosedPipe(int error)
{
#ifdef _WIN32
  return error == EPIPE || error == EINVAL; // its C library knows no better reason
#else
  return error == EPIPE;
#endif
}
}

#endif
