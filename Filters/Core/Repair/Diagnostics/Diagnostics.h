// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Diagnostics.h
 * @brief Reports defects of a surface as data: kind, count, first ids. Changes and repairs nothing.
 *
 *     points:      not finite, too large, used by no triangle
 *     triangles:   point ids out of range, repeated corner, no area, duplicate
 *                  (same or opposite orientation)
 *     after merging equal points (Cleaning.h) and without triangles that have no area:
 *       edges:     boundary, three or more triangles, inconsistent orientation
 *       vertices:  the triangles do not form one fan
 *       gaps:      boundary points very near to another boundary, which welding would close
 *     surface:     closed components that are inside out, components; a size
 *                  that is unusual for a bone in mm
 */
#ifndef BoneDecimate_Core_Repair_Diagnostics_Diagnostics_h
#define BoneDecimate_Core_Repair_Diagnostics_Diagnostics_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate
{
enum class DiagnosticKind : int
{
  NonFinitePoints = 0,
  HugePoints,      ///< A coordinate beyond 1e30.
  IdsOutOfRange,   ///< Triangles with a point id out of range.
  RepeatedCorners, ///< Triangles with a repeated corner, after merging equal points.
  NoArea,          ///< Triangles with three different collinear corners.
  Duplicates,      ///< Triangles with the corners and orientation of an earlier one.
  Opposites,       ///< Triangles with the corners of an earlier one and the opposite orientation.
  UnusedPoints,
  /// Points with the coordinates of an earlier one, as in a surface of unconnected triangles.
  EqualPoints,
  NonManifoldEdges,
  InconsistentEdges, ///< Edges of two triangles of different orientation.
  PinchedPoints,     ///< Points that are not manifold although all their edges are.
  OpenEdges,         ///< Edges of one triangle.
  UnweldedPoints, ///< Diagnostic::Length: the distance over which points would have to be merged.
  InsideOut, ///< Closed components whose triangles are oriented inward: their volume is negative.
  Components,
  OddSize ///< Diagnostic::Length: the diagonal of the bounding box.
};
constexpr int NumberOfDiagnosticKinds = 17;

struct Diagnostic
{
  DiagnosticKind Kind;
  std::int64_t Count = 0;
  /// Ids of the input, ascending: at most FirstDiagnostics points or triangles, see DiagnosticInfo.
  std::vector<Index> First = {};
  double Length = std::numeric_limits<double>::quiet_NaN(); ///< mm, where the kind has one
};
constexpr std::size_t FirstDiagnostics = 8;

enum class Severity : int
{
  Note = 0, ///< Nothing wrong.
  Kept,     ///< Decimation leaves it as it is.
  Cleaned,  ///< Decimation merges or drops it, and counts that.
  Rejected  ///< Decimation rejects the input.
};

/// Describes a kind; one row of a table.
struct DiagnosticInfo
{
  std::string Word;     ///< "non_manifold_edges"
  std::string Plural;   ///< What follows the count: "points are not finite".
  std::string Singular; ///< The same for the count 1.
  std::string IdKind; ///< What the ids of Diagnostic::First identify: "point", "triangle" or empty.
  bonedecimate::Severity Severity = Severity::Note;
};
const DiagnosticInfo& InfoOf(DiagnosticKind kind);

/// Without the count.
const std::string& DiagnosticSentence(const Diagnostic& diagnostic);

/// One word: "rejected".
const char* SeverityWord(Severity severity);

/// The diagnostics found, in the order of the kinds. Components are always included. Ends after the
/// first kind for which the input is rejected.
std::vector<Diagnostic> Diagnose(const Surface& surface, int threads = 0);
}

#endif
