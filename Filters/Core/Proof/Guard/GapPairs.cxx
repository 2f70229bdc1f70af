// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapPairs.h"

#include "PartTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Least ratio of a gap to its initial width.
constexpr double MinGapRatio = 0.5;

/// mm, at first, where the two stand; infinite if there was none.
double GapOf(const GapRule& widths, const Piece& a, const Piece& b)
{
  const Gap both = a.MinGap.And(b.MinGap);
  return widths.PartOf(a.Vertices[0]) == widths.PartOf(b.Vertices[0]) ? both.ToOwn : both.ToOther;
}
}

double ReachOf(const Gap& gap)
{
  double reach = 0.0;
  for (const float width : { gap.ToOwn, gap.ToOther })
  {
    reach = std::isfinite(width) ? std::max<double>(reach, MinGapRatio * width) : reach;
  }
  return reach;
}

//------------------------------------------------------------------------------
bool IsTooNear(
  const GapRule& widths, const Piece& piece, const Piece& near, const std::vector<Piece>& old)
{
  const double gap = GapOf(widths, piece, near);
  const bool isOwn = widths.PartOf(piece.Vertices[0]) == widths.PartOf(near.Vertices[0]);
  const double squared = MinGapRatio * MinGapRatio * gap * gap; // mm^2
  if (!std::isfinite(gap) || SquaredDistance(piece, near) >= squared ||
    CountShared(piece, near) > 0)
  {
    return false;
  }
  const Vector3 normal = isOwn ? piece.Normal() : Vector3::Zero();
  const Vector3 normalOfNear = isOwn ? near.Normal() : Vector3::Zero();
  if (isOwn && Dot(normal, normalOfNear) >= 0.0)
  {
    return false;
  }
  const Way way = WayBetween(piece.Corners, near.Corners);
  if (way.SquaredLength >= squared || (isOwn && !Face(normal, normalOfNear, way.FromAToB)))
  {
    return false;
  }
  return std::all_of(old.begin(), old.end(),
    [&](const Piece& gone)
    {
      return CountShared(gone, near) > 0 ||
        WayBetween(gone.Corners, near.Corners).SquaredLength > way.SquaredLength;
    });
}

//------------------------------------------------------------------------------
void MergeGaps(const EditJournal& journal, const HalfEdgeMesh& mesh, GapRule& widths)
{
  for (Index edit = 0; edit < journal.Count(); ++edit)
  {
    const JournalEntry& entry = journal.Entry(edit);
    if (!entry.IsUndone)
    {
      const Index keep = mesh.OriginalVertex(entry.Keep);
      widths.Set(keep, widths.Of(keep).And(widths.Of(mesh.OriginalVertex(entry.Gone))));
    }
  }
}
}
