// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunWarnings.h"

#include "Repair/Diagnostics/SurfaceHints.h"
#include "WeldOperation.h"

namespace bonedecimate
{
std::vector<std::string> RunWarnings(const Surface& input, const Report& report, int threads)
{
  std::vector<std::string> warnings = WeldSentences(report.Weld);
  const std::vector<std::string> ofInput = InputWarnings(report);
  warnings.insert(warnings.end(), ofInput.begin(), ofInput.end());
  if (report.Status == InputStatus::Good)
  {
    const SurfaceStatistics& cleaned = report.Input;
    const std::vector<std::string> hints = SurfaceHints(input,
      { cleaned.Points, cleaned.Faces, report.Cleaning.NonManifoldPoints, cleaned.Components,
        cleaned.BoundaryEdges, cleaned.Volume },
      threads);
    warnings.insert(warnings.end(), hints.begin(), hints.end());
  }
  return warnings;
}
}
