// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GapPairs.h"

#include "FaceGrid.h"
#include "Parallel.h"
#include "PartTree.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
bool IsTooNear(
  const GapRule& widths, const Piece& piece, const Piece& near, const std::vector<Piece>& old)
{
  const double gap = GapOf(widths, piece, near);
  const bool isOwn = widths.PartOf(piece.Vertices[0]) == widths.PartOf(near.Vertices[0]);
  const double squared = LeastGapRatio * LeastGapRatio * gap * gap; // mm^2
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

//------------------------------------------------------------------------------
namespace
{
/// With the least gap of its corners.
Piece PieceWithGap(const HalfEdgeMesh& mesh, const GapRule& widths, const Triangle& vertices,
  const TriangleCorners& corners)
{
  Piece piece(mesh, vertices, corners);
  piece.LeastGap = widths.LeastOf(piece.Vertices);
  piece.Reach = ReachOf(piece.LeastGap);
  return piece;
}

/// The pairs of faces of a drafted mesh that are too near.
class NarrowedGaps
{
public:
  NarrowedGaps(
    const HalfEdgeMesh& mesh, const GapRule& widths, const EditJournal& journal, int threads)
    : Mesh(mesh)
    , Widths(widths)
    , Journal(journal)
    , History(mesh, journal, threads)
  {
    MergeGaps(journal, mesh, this->Widths);
  }

  /// Adds the later edit of each pair of this face.
  void Look(FaceId face, std::vector<Index>& edits) const
  {
    const Triangle v = this->Mesh.Corners(face);
    const Piece piece = PieceWithGap(this->Mesh, this->Widths, v, CornersOf(this->Mesh, v));
    this->History.VisitAt(FloatBox(piece.Corners, piece.Reach), this->Journal.Count(),
      [&](const FaceVersion& version)
      {
        const Triangle vertices = this->Mesh.Corners(version.Face);
        if (version.Face == face || !this->MayBeTooNear(piece, vertices))
        {
          return;
        }
        const Piece near =
          PieceWithGap(this->Mesh, this->Widths, vertices, CornersOf(this->Mesh, vertices));
        const FaceVersion own = this->Journal.LastVersion(face, v);
        int left = MostSteps;
        if (IsTooNear(this->Widths, piece, near, {}) && !this->WasAsNear(own, version, left))
        {
          edits.push_back(std::max(own.Made, version.Made));
        }
      });
  }

private:
  static constexpr int MostSteps = 1000;

  /// By what costs little.
  bool MayBeTooNear(const Piece& piece, const Triangle& vertices) const
  {
    Gap gap = piece.LeastGap;
    bool isApart = true;
    Index last = None;
    for (const VertexId vertex : vertices)
    {
      last = this->Mesh.OriginalVertex(vertex);
      gap = gap.And(this->Widths.Of(last));
      isApart = isApart &&
        std::find(piece.Vertices.begin(), piece.Vertices.end(), last) == piece.Vertices.end();
    }
    const bool isOwn = this->Widths.PartOf(piece.Vertices[0]) == this->Widths.PartOf(last);
    return isApart && std::isfinite(isOwn ? gap.ToOwn : gap.ToOther);
  }

  /// Whether the pair goes back to one of the input that was as near, over pairs that were as near: from each edit to a face that
  /// it replaced. So no edit has made such a gap narrower than it was, which is the rule of single edits.
  bool WasAsNear(const FaceVersion& one, const FaceVersion& other, int& left) const
  {
    const bool isOneLater = one.Made > other.Made;
    const FaceVersion& later = isOneLater ? one : other;
    const FaceVersion& near = isOneLater ? other : one;
    if (later.Made == None)
    {
      return true;
    }
    const Piece nearPiece = this->PieceOf(near);
    const double now =
      WayBetween(this->Journal.CornersOf(later), nearPiece.Corners).SquaredLength; // mm^2
    for (Index i = 0; i < this->Journal.Entry(later.Made).NumberOfFaces && --left > 0; ++i)
    {
      const FaceVersion& old = this->Journal.OldFace(later.Made, i);
      const Piece oldPiece = this->PieceOf(old);
      if (CountShared(oldPiece, nearPiece) == 0 &&
        WayBetween(oldPiece.Corners, nearPiece.Corners).SquaredLength <= now &&
        this->WasAsNear(old, near, left))
      {
        return true;
      }
    }
    return false;
  }

  Piece PieceOf(const FaceVersion& face) const
  {
    return { this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face) };
  }

  const HalfEdgeMesh& Mesh;
  GapRule Widths;
  const EditJournal& Journal;
  FaceHistory History; // after the last edit
};

/// The faces that edits have changed.
std::vector<FaceId> ChangedFaces(const HalfEdgeMesh& mesh, const EditJournal& journal)
{
  std::vector<FaceId> faces;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face) && journal.IsChanged(face))
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// Those that were not there in the last call.
std::vector<FaceId> NewFaces(
  const std::vector<FaceId>& changed, const EditJournal& journal, std::vector<Index>& checked)
{
  std::vector<FaceId> faces;
  std::copy_if(changed.begin(), changed.end(), std::back_inserter(faces),
    [&](FaceId face)
    {
      const Index version = journal.LastOfFace(face);
      return std::exchange(checked[face], version) != version;
    });
  return faces;
}

std::vector<Index> LookAt(const NarrowedGaps& gaps, const std::vector<FaceId>& faces, int threads)
{
  std::vector<std::vector<Index>> edits(NumberOfChunks(faces.size()));
  ForEachChunk(faces.size(), threads, {},
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        gaps.Look(faces[i], edits[chunk]);
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

std::vector<Index> FindNarrowedGaps(const HalfEdgeMesh& mesh, const GapRule& widths,
  const EditJournal& journal, std::vector<Index>& checked, int threads)
{
  const NarrowedGaps gaps(mesh, widths, journal, threads);
  checked.resize(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None);
  const std::vector<FaceId> changed = ChangedFaces(mesh, journal);
  const std::vector<FaceId> isNew = NewFaces(changed, journal, checked);
  std::vector<Index> edits = LookAt(gaps, isNew, threads);
  if (edits.empty() && isNew.size() < changed.size())
  {
    edits = LookAt(gaps, changed, threads);
  }
  return edits;
}
}
