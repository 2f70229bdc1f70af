// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rejection.h
 * @brief Why an edit was rejected: the table of reasons.
 *
 * A new reason is an enumerator and a row here. Counts, report, summary, pages and the schema of
 * the report follow (Utilities/write_pages.py writes the schema).
 */
#ifndef BoneDecimate_Core_Figures_Rejection_h
#define BoneDecimate_Core_Figures_Rejection_h

#include <cstddef>

namespace bonedecimate
{
/// Only an edit that was not rejected changes the mesh. RejectionTable says what the reasons mean.
enum class Rejection : int
{
  NotRejected = 0,
  NonManifold,
  Boundary,
  LinkCondition,
  Fragment,
  Flip,
  Degenerate,
  ErrorBound,
  Constrained,
  Intersection,
  VoxelLabel,
  Shape,
  Valence,
  Count ///< The number of those above.
};

constexpr std::size_t NumberOfRejections = static_cast<std::size_t>(Rejection::Count);

struct RejectionInfo
{
  Rejection Reason;
  const char* Word;     ///< In reports.
  const char* Sentence; ///< In pages: what the edit would have done, or why it was not tried.
};

/// In the order of the enumeration.
constexpr RejectionInfo RejectionTable[] = {
  { Rejection::NotRejected, "not_rejected", "the edit was made" },
  { Rejection::NonManifold, "non_manifold",
    "the surface is not manifold there and stays as it is" },
  { Rejection::Boundary, "boundary",
    "an open boundary would leave its curve, or the surface be pinched" },
  { Rejection::LinkCondition, "link_condition", "the topology would change" },
  { Rejection::Fragment, "fragment",
    "a fragment would become too small, vanish or turn inside out" },
  { Rejection::Flip, "flip", "a triangle would turn over" },
  { Rejection::Degenerate, "degenerate", "a triangle would have no area left" },
  { Rejection::ErrorBound, "error_bound",
    "it was not proved that the surfaces stay within the largest error" },
  { Rejection::Constrained, "constrained",
    "a point or a neighbor of it may not move: its tolerance is 0, or other parts have it" },
  { Rejection::Intersection, "intersection",
    "triangles would intersect, or a gap become narrower than half its width" },
  { Rejection::VoxelLabel, "voxel_label", "a voxel of the label map would get another label" },
  { Rejection::Shape, "shape", "a triangle would have an angle below the least one" },
  { Rejection::Valence, "valence", "too many triangles at a vertex would change" },
};

constexpr bool HasARowForEveryRejection()
{
  std::size_t rows = 0;
  for (const RejectionInfo& row : RejectionTable)
  {
    if (static_cast<std::size_t>(row.Reason) != rows++)
    {
      return false;
    }
  }
  return rows == NumberOfRejections;
}
static_assert(HasARowForEveryRejection(), "one row for each reason, in their order");

/// "unknown" for a value that is no reason.
constexpr const char* RejectionWord(Rejection rejection)
{
  const auto row = static_cast<std::size_t>(rejection);
  return row < NumberOfRejections ? RejectionTable[row].Word : "unknown";
}
}

#endif
