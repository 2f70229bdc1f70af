// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Profiles.h
 * @brief The one table of built-in profiles: options for a purpose, each with its reason. Program,
 * Python and documentation follow it.
 */
#ifndef BoneDecimate_Core_Options_Profiles_h
#define BoneDecimate_Core_Options_Profiles_h

#include <string>
#include <vector>

namespace bonedecimate
{
struct ProfileOption
{
  const char* Flag;         ///< The flag of a row of the option table, without dashes.
  const char* Value;        ///< As on the command line.
  const char* Reason;       ///< Continues "because".
  bool IsForLevels = false; ///< Whether it is also set for levels of detail.
};

struct Profile
{
  const char* Name;
  const char* Purpose;
  std::vector<ProfileOption> Options;
};

/// Every built-in profile once.
const std::vector<Profile>& ProfileTable();

/// The row of that name, whatever its case; null if there is none.
const Profile* FindProfile(const std::string& name);

std::vector<std::string> ProfileNames();

/// The flags of the options that say the same as this one in another way, itself included:
/// "max-error" and "preset".
std::vector<std::string> AlternativesTo(const std::string& flag);

/// The table as Markdown, for Documentation/reference/command-line.md.
std::string ProfileTableMarkdown();
}

#endif
