// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportFigures.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace bonedecimate
{
double ProvedError(const Report& report)
{
  return report.Proof.WasMade ? report.Proof.Upper() : std::numeric_limits<double>::quiet_NaN();
}

double MeasuredError(const Report& report)
{
  return report.DistancesMeasured
    ? std::max(report.OutputToInput.Maximum, report.InputToOutput.Maximum)
    : std::numeric_limits<double>::quiet_NaN();
}

std::int64_t RejectedEdits(const Report& report)
{
  return std::accumulate(
    report.Edits.Rejections.begin(), report.Edits.Rejections.end(), std::int64_t{ 0 });
}

std::int64_t RejectedEdits(const Report& report, const std::string& reason)
{
  for (std::size_t i = 1; i < NumberOfRejections; ++i)
  {
    if (reason == RejectionTable[i].Word)
    {
      return report.Edits.Rejections[i];
    }
  }
  return 0;
}

const std::vector<std::string>& KeyFigures()
{
  static const std::vector<std::string> names = { "stop_reason", "input.triangles",
    "output.triangles", "output.components", "output.checksum", "distance.output_to_input.max",
    "distance.output_to_input.mean", "distance.input_to_output.max",
    "distance.input_to_output.mean", "proof.if_unchanged.status", "proof.if_unchanged.upper",
    "proof.sentence" };
  return names;
}

const std::vector<std::string>& CertificateKeyFigures()
{
  static const std::vector<std::string> names = { "status", "lower", "upper", "boundaries",
    "reference_to_result.upper", "reference_to_result.mean", "result_to_reference.upper",
    "result_to_reference.mean" };
  return names;
}
}
