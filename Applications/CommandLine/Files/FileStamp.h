// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileStamp.h
 * @brief How a later run recognizes an input: its size and when it was changed.
 */
#ifndef BoneDecimate_Applications_FileStamp_h
#define BoneDecimate_Applications_FileStamp_h

#include <cstdint>
#include <string>

namespace bonedecimate
{
struct FileStamp
{
  std::int64_t Bytes = 0;
  std::string Modified; ///< UTC, to the nanosecond: "2024-05-01T12:00:00.123456789Z".
};

/// Stamp of a file, or of all files of a folder (DICOM): the sum of sizes and the latest change.
FileStamp StampOf(const std::string& path);
}

#endif
