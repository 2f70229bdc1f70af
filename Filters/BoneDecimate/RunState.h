// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunState.h
 * @brief The options of the next run of a filter, and the report of the last one.
 */
#ifndef BoneDecimate_RunState_h
#define BoneDecimate_RunState_h

#include "NamedEntries.h"
#include "Options/OptionTable.h"
#include "RejectedValues.h"
#include "Run/Report/Report.h"
#include "Run/Report/ReportTable.h"

#include "vtkBoneDecimateAlgorithm.h"

#include <string>

struct vtkBoneDecimateAlgorithm::RunState
{
  bonedecimate::Options Options;
  bonedecimate::Report Report;
  bonedecimate::NamedEntries Entries{ bonedecimate::ReportEntries(bonedecimate::Report()) };

  void Keep(const bonedecimate::Report& report)
  {
    this->Report = report;
    this->Entries = bonedecimate::NamedEntries{ bonedecimate::ReportEntries(this->Report) };
  }

  /// Sets an option of the table, or rejects its value.
  void Set(vtkBoneDecimateAlgorithm* filter, const std::string& name,
    const bonedecimate::OptionValue& value)
  {
    bonedecimate::Options changed = this->Options;
    this->Take(filter, name, changed,
      bonedecimate::SetOption(changed, *bonedecimate::FindOption(name), value));
  }

  /// Sets an option from text.
  void SetFromText(
    vtkBoneDecimateAlgorithm* filter, const std::string& name, const std::string& text)
  {
    bonedecimate::Options changed = this->Options;
    this->Take(filter, name, changed,
      bonedecimate::SetOptionFromText(changed, *bonedecimate::FindOption(name), text));
  }

  void PrintOption(ostream& os, vtkIndent indent, const char* name) const
  {
    const bonedecimate::OptionInfo& info = *bonedecimate::FindOption(name);
    os << indent << name << ": " << bonedecimate::OptionText(this->Options, info)
       << (info.Unit.empty() ? "" : " ") << info.Unit << "\n";
  }

private:
  /// The options as they are after one was set, or what is wrong with its value.
  void Take(vtkBoneDecimateAlgorithm* filter, const std::string& name,
    const bonedecimate::Options& changed, const std::string& problem)
  {
    const bonedecimate::OptionInfo& info = *bonedecimate::FindOption(name);
    const bool isValid = filter->Rejected().Check(
      filter, name, problem.empty() ? filter->OptionProblem(changed, name) : problem);
    const bool isChanged =
      bonedecimate::GetOption(this->Options, info) != bonedecimate::GetOption(changed, info) ||
      this->Options.TargetReductionIsExplicit != changed.TargetReductionIsExplicit;
    if (isValid && isChanged)
    {
      this->Options = changed;
      filter->Modified();
      filter->OptionChanged(name);
    }
  }
};

#endif
