// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedEntries.h"

#include "Options/NumberRange.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
const ReportEntry* NamedEntries::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&](const ReportEntry& entry) { return entry.Name == name; });
  return found == this->Entries.end() ? nullptr : &*found;
}

std::string NamedEntries::Name(int entry) const
{
  const bool exists = entry >= 0 && entry < this->Count();
  return exists ? this->Entries[static_cast<std::size_t>(entry)].Name : std::string();
}

std::string NamedEntries::Unit(const std::string& name) const
{
  const ReportEntry* entry = this->Find(name);
  return entry ? entry->Unit : std::string();
}

double NamedEntries::Value(const std::string& name) const
{
  const ReportEntry* entry = this->Find(name);
  if (entry && std::holds_alternative<double>(entry->Value))
  {
    return std::get<double>(entry->Value);
  }
  return entry && std::holds_alternative<std::int64_t>(entry->Value)
    ? static_cast<double>(std::get<std::int64_t>(entry->Value))
    : std::numeric_limits<double>::quiet_NaN();
}

std::string NamedEntries::Text(const std::string& name) const
{
  const ReportEntry* entry = this->Find(name);
  if (!entry)
  {
    return {};
  }
  if (const auto* text = std::get_if<std::string>(&entry->Value))
  {
    return *text;
  }
  if (const auto* whole = std::get_if<std::int64_t>(&entry->Value))
  {
    return std::to_string(*whole);
  }
  return NumberText(std::get<double>(entry->Value));
}
}
