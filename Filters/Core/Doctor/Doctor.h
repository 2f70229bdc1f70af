// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Doctor.h
 * @brief What is odd about a surface, as data: kind, how many, which first. Nothing is changed and nothing repaired.
 *
 *     points:      not finite, too large, used by no triangle
 *     triangles:   ids that are not there, a corner twice, no area, the same corners again (same or opposite side)
 *     with equal points taken for one (Cleaning.h), and what has no area left out:
 *       edges:     open, of three or more triangles, run along twice in the same direction
 *       vertices:  whose triangles are not one fan
 *       gaps:      points of open borders nearly on another border: what welding would close
 *     the whole:   components; a size that is no size of a bone in mm
 */
#ifndef BoneDecimate_Core_Doctor_Doctor_h
#define BoneDecimate_Core_Doctor_Doctor_h

#include "Surface.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate
{
enum class FindingKind : int
{
  NonFinitePoints = 0,
  HugePoints,      ///< A coordinate beyond 1e30.
  IdsOutOfRange,   ///< Triangles that name a point that is not there.
  RepeatedCorners, ///< Triangles with a corner twice, equal points included.
  NoArea,          ///< Triangles of three different corners on a line.
  Duplicates,      ///< Triangles that repeat an earlier one.
  Opposites,       ///< Triangles that are the back of an earlier one.
  UnusedPoints,
  EqualPoints, ///< Points at the place of an earlier one: a surface whose triangles do not share points.
  NonManifoldEdges,
  InconsistentEdges, ///< Of two triangles that look to different sides of the surface.
  PinchedPoints,     ///< Not manifold, though all its edges are.
  OpenEdges,         ///< Of one triangle.
  UnweldedPoints,    ///< Finding::Length: the distance over which points would have to be merged.
  Components,
  OddSize ///< Finding::Length: the diagonal of the bounding box.
};
constexpr int NumberOfFindingKinds = 16;

struct Finding
{
  FindingKind Kind;
  std::int64_t Count = 0;
  std::vector<Index>
    First = {}; ///< Ids of the input, ascending: at most FirstFindings points or triangles; see FindingInfo.
  double Length = std::numeric_limits<double>::quiet_NaN(); ///< mm, where the kind has one
};
constexpr std::size_t FirstFindings = 8;

enum class Severity : int
{
  Note = 0, ///< Nothing wrong.
  Kept,     ///< Decimation leaves it as it is.
  Cleaned,  ///< Decimation merges or drops it, and counts that.
  Refused   ///< Decimation refuses the input.
};

/// What a kind means; one row of a table.
struct FindingInfo
{
  std::string Word; ///< "non_manifold_edges"
  std::string Sentence;
  std::string Of; ///< What Finding::First are ids of: "point", "triangle" or empty.
  bonedecimate::Severity Severity = Severity::Note;
};
const FindingInfo& InfoOf(FindingKind kind);

/// One word: "refused".
const char* SeverityWord(Severity severity);

/// Only what was found, in the order of the kinds; components always. After anything that is refused nothing more is
/// looked for.
std::vector<Finding> Examine(const Surface& surface, int threads = 0);
}

#endif
