// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConfigurationFile.h
 * @brief A file of options and profiles in TOML.
 *
 *     mode = "Accurate"             # options of bonedecimate itself, that is of decimate
 *     [levels]                      # of another command
 *     coarsest = 5000
 *     [profiles.hip]                # what --profile hip sets
 *     max-error = 0.3
 *     [profiles.hip.levels]         # the same for another command
 *     max-error = 0.5
 *
 * Keys are the flags of options without dashes; switches are true or false; repeated options and
 * lists are arrays.
 */
#ifndef BoneDecimate_Applications_ConfigurationFile_h
#define BoneDecimate_Applications_ConfigurationFile_h

#include "Arguments/CliForward.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate
{
/// Options of one command, in order: flag without dashes, and values; of a switch that is on none.
using SettingsList = std::vector<std::pair<std::string, std::vector<std::string>>>;

class ConfigurationFile
{
public:
  /**
   * Reads and checks the whole file, what is not used of it, too.
   * @param program Has the commands and options that keys may be of.
   * @throws Failure(ExitCode::Usage) with a sentence that names the file and the key or section.
   */
  ConfigurationFile(const std::string& path, const CLI::App& program);

  /// Options of a command outside of profiles; may be empty.
  SettingsList OptionsOf(const std::string& command) const;

  std::vector<std::string> GetProfiles() const;

  /// Options of a profile by command; empty if there is no profile of that name.
  std::map<std::string, SettingsList> OptionsOfProfile(const std::string& profile) const;

private:
  std::map<std::string, SettingsList> Options; // by command
  std::map<std::string, std::map<std::string, SettingsList>> Profiles;
};
}

#endif
