// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "Modes.h"
#include "NumberRange.h"
#include "OptionRow.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double MaxInteger = std::numeric_limits<int>::max();

std::vector<OptionInfo> MakeTable()
{
  std::vector<OptionInfo> rows;
#define BONEDECIMATE_OPTION(Type, Name, Default, Traits, Sentence)                                 \
  rows.push_back(OptionRow(#Name, &Options::Name, Sentence).Traits.Info);
#include "OptionRows.def"
#undef BONEDECIMATE_OPTION
  return rows;
}

bool NeedsComponents(const OptionInfo& info)
{
  return std::any_of(info.Needs.begin(), info.Needs.end(),
    [](const NeedList& needs)
    { return std::find(needs.begin(), needs.end(), Need::Components) != needs.end(); });
}
}

const std::vector<OptionInfo>& OptionTable()
{
  static const std::vector<OptionInfo> table = MakeTable();
  return table;
}

const OptionInfo* FindOption(const std::string& name)
{
  const std::vector<OptionInfo>& table = OptionTable();
  const auto row = std::find_if(
    table.begin(), table.end(), [&name](const OptionInfo& info) { return info.Name == name; });
  return row == table.end() ? nullptr : &*row;
}

bool IsUsed(const Options& options, const OptionInfo& info)
{
  return info.IsUsed != nullptr ? info.IsUsed(options)
                                : GetOption(options, info) != GetOption(Options{}, info);
}

std::vector<std::string> ChangedOptions(const Options& options)
{
  std::vector<std::string> names;
  for (const OptionInfo& info : OptionTable())
  {
    if (GetOption(options, info) != GetOption(Options{}, info))
    {
      names.push_back(info.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
bool Options::Prunes() const
{
  const std::vector<OptionInfo>& table = OptionTable();
  return std::any_of(table.begin(), table.end(),
    [this](const OptionInfo& info) { return NeedsComponents(info) && IsUsed(*this, info); });
}

//------------------------------------------------------------------------------
Options Options::WithoutPruning() const
{
  Options rest = *this;
  for (const OptionInfo& info : OptionTable())
  {
    if (NeedsComponents(info))
    {
      std::visit([&rest](auto field) { rest.*field = Options().*field; }, info.Field);
    }
  }
  return rest;
}
}
