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
/// Steps back from a pair of faces to one of the initial mesh.
constexpr int MaxSteps = 1000;
}

StateCheck::StateCheck(const HalfEdgeMesh& mesh, const GapRule& widths,
  const WrittenPositions& written, const EditJournal& journal)
  : Mesh(mesh)
  , InitialWidths(widths)
  , Written(written)
  , Journal(journal)
  , Widths(widths)
  , CheckedEdits(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
{
}

//------------------------------------------------------------------------------
std::vector<Index> StateCheck::FindEditsToUndo(int threads)
{
  const std::vector<FaceId> changed = this->TakeChanged(threads);
  this->Widths = this->InitialWidths;
  MergeGaps(this->Journal, this->Mesh, this->Widths);
  std::vector<std::vector<Index>> edits(NumberOfChunks(changed.size()));
  ForEachChunk(changed.size(), threads, {},
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        this->FindBadPairs(changed[i], edits[chunk]);
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
    std::vector<FloatBox> boxes(this->CheckedEdits.size());
    ForEachId(boxes.size(), threads,
      [&](std::size_t i)
      {
        const FaceId face = static_cast<Index>(i);
        boxes[i] = this->Mesh.IsAlive(face) ? boxOf(face) : FloatBox();
      });
    this->Tree.emplace(std::move(boxes), threads);
  }
  std::vector<FaceId> changed;
  for (std::size_t i = 0; i < this->CheckedEdits.size(); ++i)
  {
    const FaceId face = static_cast<Index>(i);
    const Index edit = this->Journal.LastEditOf(face);
    if (std::exchange(this->CheckedEdits[i], edit) != edit)
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
void StateCheck::FindBadPairs(FaceId face, std::vector<Index>& edits) const
{
  PairFace piece = this->PairFaceOf(face);
  const double reach = std::max(piece.Reach, this->Written.Rounding());
  const bool isChanged = this->Journal.IsChanged(face);
  this->Tree->VisitMeeting(FloatBox(piece.Corners, reach),
    [&](std::size_t i)
    {
      const FaceId other = static_cast<Index>(i);
      if (other != face && (isChanged || this->Journal.IsChanged(other)))
      {
        PairFace near = this->PairFaceOf(other);
        if (this->IsBad(face, piece, other, near))
        {
          edits.push_back(
            std::max(this->Journal.LastEditOf(face), this->Journal.LastEditOf(other)));
        }
      }
    });
}

//------------------------------------------------------------------------------
bool StateCheck::IsBad(FaceId face, PairFace& piece, FaceId other, PairFace& near) const
{
  if (Meet(piece, near, this->Written))
  {
    return true;
  }
  int stepsLeft = MaxSteps;
  return IsTooNear(this->Widths, piece, near, {}) &&
    !this->WasAsNear(this->VersionOf(face), this->VersionOf(other), stepsLeft);
}

//------------------------------------------------------------------------------
/// Whether the pair goes back, from each edit to a face that it replaced, over pairs that were as
/// near to one of the initial mesh that was. Then no edit has narrowed the gap, which is the rule
/// for single edits.
bool StateCheck::WasAsNear(const FaceVersion& one, const FaceVersion& other, int& stepsLeft) const
{
  const bool isOneLater = one.MadeBy > other.MadeBy;
  const FaceVersion& later = isOneLater ? one : other;
  const FaceVersion& near = isOneLater ? other : one;
  if (later.MadeBy == None)
  {
    return true;
  }
  const PairFace nearPiece = this->PairFaceOf(near);
  // mm^2
  const double now =
    ShortestConnection(this->Journal.CornersOf(later), nearPiece.Corners).SquaredLength;
  for (Index i = 0; i < this->Journal.Entry(later.MadeBy).NumberOfFaces && --stepsLeft > 0; ++i)
  {
    const FaceVersion& old = this->Journal.OldFace(later.MadeBy, i);
    const PairFace oldPiece = this->PairFaceOf(old);
    if (CountCommon(oldPiece.Vertices, nearPiece.Vertices) == 0 &&
      ShortestConnection(oldPiece.Corners, nearPiece.Corners).SquaredLength <= now &&
      this->WasAsNear(old, near, stepsLeft))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/// The face with the least gap of its corners.
PairFace StateCheck::PairFaceOf(FaceId face) const
{
  PairFace piece(this->Mesh, this->Mesh.Corners(face), PositionsOf(this->Mesh, face));
  piece.MinGap = this->Widths.MinOf(piece.Vertices);
  piece.Reach = ReachOf(piece.MinGap);
  return piece;
}

//------------------------------------------------------------------------------
PairFace StateCheck::PairFaceOf(const FaceVersion& face) const
{
  return { this->Mesh, this->Journal.VerticesOf(face), this->Journal.CornersOf(face) };
}
}
