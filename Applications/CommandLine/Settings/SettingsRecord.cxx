// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Settings/SettingsRecord.h"

#include "Options/OptionTable.h"

#include <cctype>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

Json JsonOf(const SettingsRecord& settings)
{
  Json json = Json::object();
  for (const auto& [name, text] :
    { std::pair("profile", &settings.Profile), std::pair("file", &settings.File) })
  {
    if (!text->empty())
    {
      json[name] = *text;
    }
  }
  json["options"] = settings.Options;
  json["overridden"] = settings.Overridden;
  return json;
}

bool HasWord(const std::string& text, const std::string& word)
{
  const std::size_t at = text.find(word);
  const std::size_t end = at + word.size();
  return at != std::string::npos &&
    (end == text.size() ||
      (std::isalnum(static_cast<unsigned char>(text[end])) == 0 && text[end] != '-'));
}
}

void AddSettingsTo(nlohmann::ordered_json& report, const SettingsRecord& settings)
{
  if (!settings.IsEmpty())
  {
    report["settings"] = JsonOf(settings);
  }
}

std::string SettingsText(const SettingsRecord& settings)
{
  return JsonOf(settings).dump(-1, ' ', true, Json::error_handler_t::replace);
}

SettingsRecord ReadSettings(const std::string& text)
{
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    return {};
  }
  return { json.value("profile", ""), json.value("file", ""),
    json.value("options", std::map<std::string, std::string>()),
    json.value("overridden", std::vector<std::string>()) };
}

std::string OriginText(const SettingsRecord& settings)
{
  const std::string profile = settings.Profile.empty() ? "" : "profile '" + settings.Profile + "'";
  const std::string file = settings.File.empty() ? "" : "'" + settings.File + "'";
  return profile + (profile.empty() || file.empty() ? "" : " with ") + file;
}

std::string SettingsSentence(const SettingsRecord& settings)
{
  std::string text = OriginText(settings) + ":";
  for (const auto& [flag, value] : settings.Options)
  {
    text += " --" + flag + (value.empty() ? "" : " " + value);
  }
  text += settings.Options.empty() ? " nothing" : "";
  std::string overridden;
  for (const std::string& flag : settings.Overridden)
  {
    overridden += (overridden.empty() ? "" : ", ") + flag;
  }
  return overridden.empty() ? text : text + "; the command line sets " + overridden;
}

std::string WithOrigin(const std::string& message, const SettingsRecord& settings)
{
  for (const auto& [flag, value] : settings.Options)
  {
    if (HasWord(message, "--" + flag))
    {
      std::string text = message + "; --";
      return text.append(flag).append(" is from ").append(OriginText(settings));
    }
  }
  return message;
}
}
