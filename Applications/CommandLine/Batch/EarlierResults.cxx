// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EarlierResults.h"

#include "BatchOptions.h"
#include "ExitCode.h"
#include "Options/OptionTable.h"
#include "Report/JsonReport.h"

#include <map>
#include <optional>

namespace bonedecimate
{
bool HasEarlierResult(const BatchBone& bone, const Arguments& arguments)
{
  ReportSubject subject = SubjectOf(arguments, bone.Input, bone.Output);
  subject.Given = OptionsFor(bone, arguments);
  return ReportMatches(bone.Report, bone.Output, subject);
}

std::string OtherOptions(const BatchBone& bone, const Arguments& arguments)
{
  std::map<std::string, std::string> requested = OptionsFor(bone, arguments);
  requested.erase(FindOption("NumberOfThreads")->Flag);
  const auto earlier = OptionsOfReport(bone.Report, bone.Output, bone.Input);
  if (!earlier || *earlier == requested)
  {
    return {};
  }
  return earlier->empty() ? "no options" : OptionsText(*earlier);
}

void RejectOtherOptions(const std::vector<BatchBone>& bones, const Arguments& arguments)
{
  std::size_t count = 0;
  std::string first;
  for (const BatchBone& bone : bones)
  {
    const bool matters = bone.IsBone() && !arguments.Force;
    const std::string options = matters ? OtherOptions(bone, arguments) : std::string();
    if (!options.empty() && ++count == 1)
    {
      first.append("'").append(bone.Name).append("' (").append(options).append(")");
    }
  }
  if (count > 0)
  {
    throw Failure(ExitCode::Usage,
      "'" + arguments.Output + "' has " + std::to_string(count) +
        (count == 1 ? " result" : " results") + " of other options, the first is " + first +
        ": another folder keeps them, --force does all chosen inputs again");
  }
}
}
