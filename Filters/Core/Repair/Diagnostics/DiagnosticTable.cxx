// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Diagnostics.h"

#include <array>

namespace bonedecimate
{
const DiagnosticInfo& InfoOf(DiagnosticKind kind)
{
  static const std::array<DiagnosticInfo, NumberOfDiagnosticKinds> table = { {
    { "non_finite_points", "points are not finite", "point is not finite", "point",
      Severity::Rejected },
    { "huge_points", "points have a coordinate beyond 1e30", "point has a coordinate beyond 1e30",
      "point", Severity::Rejected },
    { "ids_out_of_range", "triangles have a point id out of range",
      "triangle has a point id out of range", "triangle", Severity::Rejected },
    { "repeated_corners", "triangles have the same corner twice",
      "triangle has the same corner twice", "triangle", Severity::Cleaned },
    { "no_area", "triangles have no area", "triangle has no area", "triangle", Severity::Cleaned },
    { "duplicates", "triangles repeat an earlier one", "triangle repeats an earlier one",
      "triangle", Severity::Kept },
    { "opposites", "triangles are the back of an earlier one",
      "triangle is the back of an earlier one", "triangle", Severity::Kept },
    { "unused_points", "points are used by no triangle", "point is used by no triangle", "point",
      Severity::Cleaned },
    { "equal_points", "points lie where an earlier one does",
      "point lies where an earlier one does", "point", Severity::Cleaned },
    { "non_manifold_edges", "edges have three or more triangles",
      "edge has three or more triangles", "triangle", Severity::Kept },
    { "inconsistent_edges", "edges have two triangles that look to different sides",
      "edge has two triangles that look to different sides", "triangle", Severity::Kept },
    { "pinched_points", "points connect parts that have no edge in common there",
      "point connects parts that have no edge in common there", "point", Severity::Kept },
    { "open_edges", "edges have one triangle: open boundaries",
      "edge has one triangle: an open boundary", "triangle", Severity::Note },
    { "unwelded_points", "points of a boundary lie nearly on another boundary",
      "point of a boundary lies nearly on another boundary", "point", Severity::Kept },
    { "inside_out", "closed parts are inside out: their triangles are oriented inward",
      "closed part is inside out: its triangles are oriented inward", "triangle", Severity::Kept },
    { "components", "connected parts", "connected part", "", Severity::Note },
    { "odd_size", "the size is not that of a bone in millimeters",
      "the size is not that of a bone in millimeters", "", Severity::Note },
  } };
  return table[static_cast<std::size_t>(kind)];
}

const std::string& DiagnosticSentence(const Diagnostic& diagnostic)
{
  const DiagnosticInfo& info = InfoOf(diagnostic.Kind);
  return diagnostic.Count == 1 ? info.Singular : info.Plural;
}

const char* SeverityWord(Severity severity)
{
  static const std::array<const char*, 4> words = { "note", "kept", "cleaned", "rejected" };
  const auto number = static_cast<std::size_t>(severity);
  return number < words.size() ? words[number] : "unknown";
}
}
