// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapPairs.h"

#include "FragmentTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Least ratio of a gap to its initial width.
constexpr double MinGapRatio = 0.5;

/// mm, the initial width of the gap between two faces; infinite if there was none.
double GapOf(const GapRule& widths, const PairFace& a, const PairFace& b)
{
  const Gap both = Min(a.MinGap, b.MinGap);
  return widths.FragmentOf(a.Vertices[0]) == widths.FragmentOf(b.Vertices[0])
    ? both.WithinFragment
    : both.BetweenFragments;
}
}

double ReachOf(const Gap& gap)
{
  double reach = 0.0;
  for (const float width : { gap.WithinFragment, gap.BetweenFragments })
  {
    reach = std::isfinite(width) ? std::max<double>(reach, MinGapRatio * width) : reach;
  }
  return reach;
}

//------------------------------------------------------------------------------
bool IsTooNear(const GapRule& widths, const PairFace& face, const PairFace& near,
  const std::vector<PairFace>& old)
{
  const double gap = GapOf(widths, face, near);
  const bool isOwn = widths.FragmentOf(face.Vertices[0]) == widths.FragmentOf(near.Vertices[0]);
  const double squared = MinGapRatio * MinGapRatio * gap * gap; // mm^2
  if (!std::isfinite(gap) || SquaredDistance(face, near) >= squared ||
    CountCommon(face.Vertices, near.Vertices) > 0)
  {
    return false;
  }
  const Vector3 normal = isOwn ? face.Normal() : Vector3::Zero();
  const Vector3 normalOfNear = isOwn ? near.Normal() : Vector3::Zero();
  if (isOwn && Dot(normal, normalOfNear) >= 0.0)
  {
    return false;
  }
  const Connection way = ShortestConnection(face.Corners, near.Corners);
  if (way.SquaredLength >= squared || (isOwn && !FaceEachOther(normal, normalOfNear, way.FromAToB)))
  {
    return false;
  }
  return std::all_of(old.begin(), old.end(),
    [&](const PairFace& gone)
    {
      return CountCommon(gone.Vertices, near.Vertices) > 0 ||
        ShortestConnection(gone.Corners, near.Corners).SquaredLength > way.SquaredLength;
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
      widths.Set(keep, Min(widths.Of(keep), widths.Of(mesh.OriginalVertex(entry.Gone))));
    }
  }
}
}
