// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSummary.h"

#include "CountText.h"
#include "NumberText.h"
#include "PlainText.h"

#include <iostream>

namespace bonedecimate
{
namespace
{
/// A wrong unit is seen by it.
void PrintSize(const ReportFields& report)
{
  if (const std::optional<double> diagonal = report.Number("input.diagonal"))
  {
    std::cout << "size            " << SizeText(*diagonal) << " mm, the diagonal of the input\n";
  }
}

/// Only if there are many.
void PrintSpecks(const SpeckFigures& specks)
{
  if (specks.AreMany())
  {
    const auto count = [](std::int64_t number) { return GroupedText(static_cast<double>(number)); };
    const std::string size = ShortText(specks.Size);
    std::cout << "specks          " << count(specks.Specks) << " of " << count(specks.Components)
              << " components are smaller than " << size << " mm, "
              << SizeText(100.0 * specks.AreaRatio)
              << " % of the area; if they are not bone, --prune-size " << size
              << " leaves them out\n";
  }
}

/// The components left out on request, the largest first.
void PrintPruned(const ReportFields& report)
{
  constexpr int mostPrinted = 10;
  if (!report.Number("pruned.components"))
  {
    return;
  }
  std::cout << "pruned          " << CountText(report, "pruned.components") << " components, "
            << CountText(report, "pruned.triangles") << " triangles\n";
  for (int i = 0; i < mostPrinted; ++i)
  {
    const std::string path = "pruned.list." + std::to_string(i);
    if (!report.Number(path + ".triangles"))
    {
      return;
    }
    const auto length = [&](const char* name)
    { return MillimeterText(report.Number(path + name).value_or(0.0)); };
    std::cout << "  " << CountText(report, path + ".triangles") << " triangles, " << length(".size")
              << " mm, at " << length(".center.0") << ", " << length(".center.1") << ", "
              << length(".center.2") << "\n";
  }
}

/// The tunnels closed on request.
void PrintTunnels(const ReportFields& report)
{
  if (!report.Number("tunnels.closed"))
  {
    return;
  }
  double left = 0.0;
  for (const std::string& name : report.NamesBelow("tunnels.left."))
  {
    left += report.Number(name).value_or(0.0);
  }
  std::cout << "tunnels         " << CountText(report, "tunnels.closed") << " closed, "
            << static_cast<std::int64_t>(left) << " left although narrow; handles "
            << CountText(report, "tunnels.genus_before") << " -> "
            << CountText(report, "tunnels.genus_after") << "; the plugs are at most "
            << MillimeterText(report.Number("tunnels.distance").value_or(0.0))
            << " mm from the input\n";
}

/// The diagnostics of the input.
void PrintDiagnostics(const ReportFields& report)
{
  for (int i = 0;; ++i)
  {
    const std::string path = "diagnostics." + std::to_string(i);
    if (!report.Number(path + ".count"))
    {
      return;
    }
    std::cout << "found           " << CountText(report, path + ".count") << " "
              << report.Text(path + ".sentence") << " (" << report.Text(path + ".severity")
              << ")\n";
  }
}
}

void PrintInputSummary(const ReportFields& report, const SpeckFigures& specks)
{
  PrintSize(report);
  PrintSpecks(specks);
  PrintPruned(report);
  PrintTunnels(report);
  PrintDiagnostics(report);
}
}
