// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StateCheck.h"

#include "Base/Parallel.h"
#include "GapPairs.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Back from a pair of faces to one of the mesh at first.
constexpr int MaxSteps = 1000;
}

StateCheck::StateCheck(const HalfEdgeMesh& mesh, const GapRule& widths,
  const WrittenPositions& written, const EditJournal& journal)
  : Mesh(mesh)
  , WidthsAtFirst(widths)
  , Written(written)
  , Journal(journal)
  , Widths(widths)
  , Looked(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
{
}

//------------------------------------------------------------------------------
std::vector<Index> StateCheck::FindRejected(int threads)
{
  const std::vector<FaceId> changed = this->TakeChanged(threads);
  this->Widths = this->WidthsAtFirst;
  MergeGaps(this->Journal, this->Mesh, this->Widths);
  std::vector<std::vector<Index>> edits(NumberOfChunks(changed.size()));
  ForEachChunk(changed.size(), threads, {},
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        this->Look(changed[i], edits[chunk]);
      }
    });
  std::vector<Index> all;
  for (const std::vector<Index>& part : edits)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

//------------------------------------------------------------------------------
/// Existing faces that have changed since the last call.
std::vector<FaceId> StateCheck::TakeChanged(int threads)
{
  const auto boxOf = [this](FaceId face) { return FloatBox(PositionsOf(this->Mesh, face)); };
  if (!this->Tree)
  {
    std::vector<FloatBox> boxes(this->Looked.size());
    ForEachId(boxes.size(), threads,
      [&](std::size_t i)
      {
        const FaceId face = static_cast<Index>(i);
        boxes[i] = this->Mesh.IsAlive(face) ? boxOf(face) : FloatBox();
      });
    this->Tree.emplace(std::move(boxes), threads);
  }
  std::vector<FaceId> changed;
  for (std::size_t i = 0; i < this->Looked.size(); ++i)
  {
    const FaceId face = static_cast<Index>(i);
    const Index edit = this->Journal.LastOfFace(face);
    if (std::exchange(this->Looked[i], edit) != edit)
    {
      const bool isThere = this->Mesh.IsAlive(face);
      this->Tree->Set(i, isThere ? boxOf(face) : FloatBox());
      if (isThere)
      {
        changed.push_back(face);
      }
    }
  }
  return changed;
}

//------------------------------------------------------------------------------
/// Adds the later edit of each bad pair of this face.
void StateCheck::Look(FaceId face, std::vector<Index>& edits) const
{
  Piece piece = this->PieceOf(face);
  const double reach = std::max(piece.Reach, this->Written.Rounding());
  const bool isChanged = this->Journal.IsChanged(face);
  this->Tree->VisitMeeting(FloatBox(piece.Corners, reach),
    [&](std::size_t i)
    {
      const FaceId other = static_cast<Index>(i);
      if (other != face && (isChanged || this->Journal.IsChanged(other)))
      {
        Piece near = this->PieceOf(other);
        if (this->IsBad(face, piece, other, near))
        {
          edits.push_back(
            std::max(this->Journal.LastOfFace(face), this->Journal.LastOfFace(other)));
        }
      }
    });
}

//------------------------------------------------------------------------------
bool StateCheck::IsBad(FaceId face, Piece& piece, FaceId other, Piece& near) const
{
  if (Meet(piece, near, this->Written))
  {
    return true;
  }
  int left = MaxSteps;
  return IsTooNear(this->Widths, piece, near, {}) &&
    !this->WasAsNear(this->VersionOf(face), this->VersionOf(other), left);
}

//------------------------------------------------------------------------------
/// Whether the pair goes back to one of the mesh at first that was as near, over pairs that were as
/// near: from each edit to a face that it replaced. So no edit has made such a gap narrower than it
/// was, which is the rule of single edits.
bool StateCheck::WasAsNear(const FaceVersion& one, const FaceVersion& other, int& left) const
{
  const bool isOneLater = one.Made > other.Made;
  const FaceVersion& later = isOneLater ? one : other;
  const FaceVersion& near = isOneLater ? other : one;
  if (later.Made == None)
  {
    return true;
  }
  const Piece nearPiece = this->PieceOf(near);
  // mm^2
  const double now = WayBetween(this->Journal.CornersOf(later), nearPiece.Corners).SquaredLength;
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

//------------------------------------------------------------------------------
/// With the least gap of its corners.
Piece StateCheck::PieceOf(FaceId face) const
{
  Piece piece(this->Mesh, this->Mesh.Corners(face), PositionsOf(this->Mesh, face));
  piece.MinGap = this->Widths.MinOf(piece.Vertices);
  piece.Reach = ReachOf(piece.MinGap);
  return piece;
}

//------------------------------------------------------------------------------
Piece StateCheck::PieceOf(const FaceVersion& face) const
{
  return { this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face) };
}
}
