// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionConflict.h"

#include "Options/RunKinds.h"

#include <utility>
#include <vector>

namespace bonedecimate
{
std::string FindConflict(const Options& options, const RunInputs& inputs)
{
  const std::pair<bool, const char*> kinds[] = { { options.KeepVoxels == KeepVoxels::On,
                                                   "KeepingVoxels" },
    { inputs.LabelMap != nullptr, "LabelMapSurface" },
    { inputs.Reference != nullptr, "Referenced" }, { inputs.Part != nullptr, "PartOfSurface" },
    { inputs.Log != nullptr, "Recorded" } };
  std::vector<RunKind> found;
  for (const auto& [isOfKind, name] : kinds)
  {
    if (isOfKind)
    {
      found.push_back(FindRunKind(name));
    }
  }
  return FindUnsupported(found, RequestsOf(options));
}

//------------------------------------------------------------------------------
Result RejectedResult(const Options& options, const std::string& conflict)
{
  Result result;
  result.Report.Requested = options;
  result.Report.Status = InputStatus::OptionConflict;
  result.Report.Conflict = conflict;
  return result;
}
}
