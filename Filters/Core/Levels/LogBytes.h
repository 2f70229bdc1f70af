// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LogBytes.h
 * @brief A log of edits as bytes, for a file, and back. Documentation/levels.md has the format.
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
  Damaged,       ///< Cut off, longer than it says, or other bytes than were written.
  Contradictory, ///< Numbers that no run can have written.
  OtherSurface   ///< Recorded on another surface than the one given.
};

/// For people; empty if it is good.
std::string LogMessage(LogStatus status);

std::vector<unsigned char> WriteLog(const EditLog& log);

/**
 * Takes no more memory than a few times the bytes, whatever they say. What ids mean is looked at by LevelStack.
 * @param log Changed only if the answer is Good.
 */
LogStatus ReadLog(const unsigned char* bytes, std::size_t size, EditLog& log);
}

#endif
