// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapPairs.h"

#include "FaceGrid.h"
#include "Parallel.h"
#include "PartTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Least ratio of a gap to its initial width.
constexpr double LeastGapRatio = 0.5;

/// mm, at first, where the two stand; infinite if there was none.
double GapOf(const GapRule& widths, const Piece& a, const Piece& b)
{
  const Gap both = a.LeastGap.And(b.LeastGap);
  return widths.PartOf(a.Vertices[0]) == widths.PartOf(b.Vertices[0]) ? both.ToOwn : both.ToOther;
}
}

double ReachOf(const Gap& gap)
{
  double reach = 0.0;
  for (const float width : { gap.ToOwn, gap.ToOther })
  {
    reach = std::isfinite(width) ? std::max<double>(reach, LeastGapRatio * width) : reach;
  }
  return reach;
}

//------------------------------------------------------------------------------
Piece PieceWithGap(const HalfEdgeMesh& mesh, const GapRule& widths, const Triangle& vertices,
  const TriangleCorners& corners)
{
  Piece piece(mesh, vertices, corners);
  for (const Index original : piece.Vertices)
  {
    piece.LeastGap = piece.LeastGap.And(widths.Of(original));
  }
  piece.Reach = ReachOf(piece.LeastGap);
  return piece;
}

//------------------------------------------------------------------------------
bool IsTooNear(
  const GapRule& widths, const Piece& piece, const Piece& near, const std::vector<Piece>& old)
{
  const double gap = GapOf(widths, piece, near);
  const bool isOwn = widths.PartOf(piece.Vertices[0]) == widths.PartOf(near.Vertices[0]);
  const double squared = LeastGapRatio * LeastGapRatio * gap * gap; // mm^2
  if (!std::isfinite(gap) || SquaredDistance(piece, near) >= squared ||
    (isOwn && piece.Normal.dot(near.Normal) >= 0.0) || CountShared(piece, near) > 0)
  {
    return false;
  }
  const Way way = WayBetween(piece.Corners, near.Corners);
  if (way.SquaredLength >= squared || (isOwn && !Face(piece.Normal, near.Normal, way.FromAToB)))
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

//------------------------------------------------------------------------------
std::vector<Index> FindNarrowedGaps(const HalfEdgeMesh& mesh, const GapRule& widths,
  const EditJournal& journal, const FaceHistory& history, int threads)
{
  GapRule merged = widths;
  MergeGaps(journal, mesh, merged);
  const std::size_t count = static_cast<std::size_t>(mesh.NumberOfFaceSlots());
  std::vector<std::vector<Index>> edits(NumberOfChunks(count));
  const auto look = [&](FaceId face, std::vector<Index>& found)
  {
    const Triangle v = mesh.Corners(face);
    const Piece piece = PieceWithGap(mesh, merged, v, CornersOf(mesh, v));
    history.VisitAt(FloatBox(piece.Corners, piece.Reach), journal.Count(),
      [&](const FaceHistory::Version& version)
      {
        const Piece near =
          PieceWithGap(mesh, merged, version.Vertices, CornersOf(mesh, version.Vertices));
        if (version.Face != face && IsTooNear(merged, piece, near, {}))
        {
          found.push_back(std::max(journal.LastOfFace(face), journal.LastOfFace(version.Face)));
        }
      });
  };
  ForEachChunk(count, threads, {},
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const FaceId face = static_cast<Index>(i);
        if (mesh.IsAlive(face) && journal.IsChanged(face))
        {
          look(face, edits[chunk]);
        }
      }
    });
  std::vector<Index> all;
  for (const std::vector<Index>& part : edits)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
}
