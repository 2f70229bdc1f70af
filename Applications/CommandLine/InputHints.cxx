// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputHints.h"

#include "NumberText.h"
#include "ReportFields.h"

#include "vtkBoneDiagnostics.h"
#include "vtkNew.h"

#include <cstdio>

namespace bonedecimate
{
namespace
{
/// Count and length of a diagnostic; 0 if it was not made.
struct Finding
{
  vtkIdType Count = 0;
  double Length = 0.0;
};

Finding FindingOf(vtkBoneDiagnostics* diagnostics, const std::string& word)
{
  for (int i = 0; i < diagnostics->GetNumberOfDiagnostics(); ++i)
  {
    if (diagnostics->GetWord(i) == word)
    {
      return { diagnostics->GetCount(i), diagnostics->GetLength(i) };
    }
  }
  return {};
}

/// Whether diagnostics may find something.
bool IsSuspicious(const ReportFields& report)
{
  const auto number = [&report](const char* name) { return report.Number(name).value_or(0.0); };
  constexpr double many = 0.125; // of the points or triangles
  const double triangles = number("input.triangles");
  return number("input.non_manifold_points") > many * number("input.points") ||
    number("input.components") > many * triangles ||
    (number("input.volume") < 0.0 && number("input.boundary_edges") == 0.0);
}

std::string CellsText(vtkPolyData* input)
{
  const vtkIdType vertices = input->GetNumberOfVerts();
  return vertices == 0 ? std::string()
                       : std::to_string(vertices) +
      (vertices == 1
          ? " vertex cell of the input is no part of the surface and stays with its point"
          : " vertex cells of the input are no part of the surface and stay with their "
            "points") +
      "; without them the file is smaller";
}
}

std::vector<std::string> InputHints(vtkPolyData* result, vtkPolyData* input, int threads)
{
  std::vector<std::string> hints;
  if (const std::string cells = CellsText(input); !cells.empty())
  {
    hints.push_back(cells);
  }
  const ReportFields report(result);
  if (!IsSuspicious(report))
  {
    return hints;
  }
  vtkNew<vtkBoneDiagnostics> diagnostics;
  diagnostics->SetInputData(input);
  diagnostics->SetNumberOfThreads(threads);
  diagnostics->Update();
  const double triangles = report.Number("input.triangles").value_or(0.0);
  constexpr double most = 0.25;
  const Finding opposites = FindingOf(diagnostics, "opposites");
  if (static_cast<double>(opposites.Count) > most * triangles)
  {
    hints.push_back(GroupedText(static_cast<double>(opposites.Count)) +
      " triangles are the back of others: the surface is double-sided, and nothing can be "
      "simplified there; remove one of the two sides before");
  }
  const Finding unwelded = FindingOf(diagnostics, "unwelded_points");
  if (static_cast<double>(unwelded.Count) > most * triangles)
  {
    char length[32];
    std::snprintf(length, sizeof(length), "%.2g", unwelded.Length);
    hints.push_back(GroupedText(static_cast<double>(unwelded.Count)) +
      " points lie apart from others by less than " + length +
      " mm, so that triangles are not connected; --weld " + length +
      " (WeldDistance) joins such points, and its movement is part of the largest error");
  }
  const Finding insideOut = FindingOf(diagnostics, "inside_out");
  if (insideOut.Count > 0)
  {
    hints.push_back(GroupedText(static_cast<double>(insideOut.Count)) +
      (insideOut.Count == 1 ? " closed part is" : " closed parts are") +
      " inside out, and so is the result: turn the triangles, as vtkReverseSense or PyVista's "
      "flip_normals() do");
  }
  return hints;
}
}
