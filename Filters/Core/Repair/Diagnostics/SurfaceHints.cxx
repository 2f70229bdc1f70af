// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceHints.h"

#include "Diagnostics.h"

#include <cstdio>

namespace bonedecimate
{
namespace
{
bool IsInsideOut(const CountsOfInput& counts)
{
  return counts.Volume < 0.0 && counts.BoundaryEdges == 0;
}

/// Whether diagnostics may find something.
bool IsSuspicious(const CountsOfInput& counts)
{
  constexpr std::int64_t many = 8; // one of so many points or triangles
  return many * counts.NonManifoldPoints > counts.Points ||
    many * counts.Components > counts.Triangles || IsInsideOut(counts);
}

std::string OppositesText(const Diagnostic& found)
{
  return std::to_string(found.Count) +
    " triangles are the back of others: the surface is double-sided, and nothing can be "
    "simplified there; remove one of the two sides before";
}

std::string UnweldedText(const Diagnostic& found)
{
  char length[32];
  std::snprintf(length, sizeof(length), "%.2g", found.Length);
  return std::to_string(found.Count) + " points lie apart from others by less than " + length +
    " mm, so that triangles are not connected; WeldDistance " + length +
    " joins such points, and its movement is part of the largest error";
}

std::string InsideOutText(const Diagnostic& found)
{
  return std::to_string(found.Count) +
    (found.Count == 1 ? " closed part is" : " closed parts are") +
    " inside out, and so is the result: turn the triangles, as vtkReverseSense or PyVista's "
    "flip_normals() do";
}
}

std::vector<std::string> SurfaceHints(
  const Surface& surface, const CountsOfInput& counts, int threads)
{
  std::vector<std::string> hints;
  if (!IsSuspicious(counts))
  {
    return hints;
  }
  constexpr std::int64_t most = 4; // more than one of so many triangles
  for (const Diagnostic& found : Diagnose(surface, threads))
  {
    const bool areMany = most * found.Count > counts.Triangles;
    if (found.Kind == DiagnosticKind::Opposites && areMany)
    {
      hints.push_back(OppositesText(found));
    }
    else if (found.Kind == DiagnosticKind::UnweldedPoints && areMany)
    {
      hints.push_back(UnweldedText(found));
    }
    else if (found.Kind == DiagnosticKind::InsideOut && IsInsideOut(counts))
    {
      hints.push_back(InsideOutText(found));
    }
  }
  return hints;
}
}
