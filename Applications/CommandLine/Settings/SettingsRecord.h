// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SettingsRecord.h
 * @brief What a profile and a configuration file added to a command line, as reports have it.
 */
#ifndef BoneDecimate_Applications_SettingsRecord_h
#define BoneDecimate_Applications_SettingsRecord_h

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace bonedecimate
{
struct SettingsRecord
{
  std::string Profile; ///< Name of the profile; empty: none.
  std::string File;    ///< The base name of the configuration file; empty: none.
  std::map<std::string, std::string> Options; ///< Added options: flag without dashes and value.
  /// Flags that the command line sets itself, in this or in another way.
  std::vector<std::string> Overridden;

  bool IsEmpty() const { return this->Profile.empty() && this->File.empty(); }
};

/// Adds "settings" to a report, if there are any.
void AddSettingsTo(nlohmann::ordered_json& report, const SettingsRecord& settings);

/// @name Of a word of the command line. @{
std::string SettingsText(const SettingsRecord& settings);
SettingsRecord ReadSettings(const std::string& text);
/// @}

/// "profile 'print' of 'ours.toml'"
std::string OriginText(const SettingsRecord& settings);

/// One line for the summary of a run.
std::string SettingsSentence(const SettingsRecord& settings);

/// The message, and if it names an option that was added, that this is so.
std::string WithOrigin(const std::string& message, const SettingsRecord& settings);
}

#endif
