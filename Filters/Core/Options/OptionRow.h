// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OptionRow.h
 * @brief The traits that OptionRows.def gives to a row of the table of options.
 */
#ifndef BoneDecimate_Core_Options_OptionRow_h
#define BoneDecimate_Core_Options_OptionRow_h

#include "OptionTable.h"

#include <utility>

namespace bonedecimate
{
class OptionRow
{
public:
  OptionRow(const char* name, OptionField field, const char* sentence)
  {
    this->Info.Name = name;
    this->Info.Field = field;
    this->Info.Sentence = sentence;
  }

  OptionRow& Flag(const char* flag)
  {
    this->Info.Flag = flag;
    return *this;
  }

  OptionRow& Range(double minimum, double maximum, const char* unit = "")
  {
    this->Info.Minimum = minimum;
    this->Info.Maximum = maximum;
    this->Info.Unit = unit;
    return *this;
  }

  OptionRow& Choices(std::vector<std::string> names)
  {
    this->Info.Maximum = static_cast<double>(names.size() - 1);
    this->Info.Choices = std::move(names);
    return *this;
  }

  OptionRow& Needs(NeedList needs)
  {
    this->Info.Needs.push_back(std::move(needs));
    return *this;
  }

  OptionRow& UsedIf(bool (*isUsed)(const Options& options))
  {
    this->Info.IsUsed = isUsed;
    return *this;
  }

  OptionRow& Panel(PanelGroup group)
  {
    this->Info.Group = group;
    return *this;
  }

  OptionRow& NamesPointArray()
  {
    this->Info.IsPointArrayName = true;
    return *this;
  }

  OptionInfo Info;
};
}

#endif
