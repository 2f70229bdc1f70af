// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LogBytes.h
 * @brief Serializes and parses a log of edits. Filters/Core/Levels/README.md describes the format.
 */
#ifndef BoneDecimate_Core_Levels_LogBytes_h
#define BoneDecimate_Core_Levels_LogBytes_h

#include "EditLog.h"

#include <cstddef>
#include <string>

namespace bonedecimate
{
enum class LogStatus : int
{
  Good = 0,
  NotALog,
  UnknownVersion,
  Damaged,       ///< Truncated, too long, or with a wrong checksum.
  Contradictory, ///< Values that no run can have written.
  OtherSurface,  ///< Recorded on another surface.
  BadLabelMap    ///< The voxel grid or the labels of the surface cannot be used.
};

/// A sentence about the problem; empty if Good.
std::string LogMessage(LogStatus status);

std::vector<unsigned char> WriteLog(const EditLog& log);

/**
 * Uses memory of at most a few times the number of bytes, whatever they contain. LevelStack
 * validates the ids.
 * @param log Changed only if the result is Good.
 */
LogStatus ReadLog(const unsigned char* bytes, std::size_t size, EditLog& log);
}

#endif
