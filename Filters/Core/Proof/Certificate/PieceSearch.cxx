// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSearch.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
/// Up to this depth, pieces of every other depth are bounded by a cover. Deeper ones are so small
/// that few triangles are over them.
constexpr int DeepestCover = 8;
constexpr int CoverPeriod = 2;
/// Triangles of an overlay that become candidates of a joint cover. The search adds others.
constexpr std::size_t MaxMet = 32;
/// Largest distance of a point of a triangle or segment to its nearest corner, divided by the
/// longest edge.
double CoveringRatio(int corners)
{
  return corners == 3 ? 0.57735026918962584 : 0.5; // a little more than 1 / sqrt(3)
}

/// Positions of the corners of a piece that has three.
Corners PositionsOf(const Piece& piece)
{
  return { piece.Corners[0].Position, piece.Corners[1].Position, piece.Corners[2].Position };
}
}

//------------------------------------------------------------------------------
PieceSearch::PieceSearch(const Simplices& source, const Target& target, const PointValues& values,
  const SearchGoal& goal, const MaxExcess& max)
  : Source(source)
  , TargetSet(target)
  , Values(values)
  , Goal(goal)
  , MaxFound(max)
  , Overlay(source.PointTolerance.empty() ? target.BorrowCover() : nullptr)
{
}

//------------------------------------------------------------------------------
double PieceSearch::ClosingBound() const
{
  const double limit = this->Goal.CloseBelow;
  const double margin = this->Goal.Decides ? 0.0 : 2.0 * this->Goal.Slack;
  if (this->MaxFound.Value + margin <= limit)
  {
    return limit;
  }
  const double gap =
    std::max(this->Goal.MinGap, this->Goal.RelativeGap * (this->MaxFound.Value + this->Goal.Scale));
  return std::max(limit, this->MaxFound.Value + gap);
}

//------------------------------------------------------------------------------
double PieceSearch::Explore(Index simplex, std::int64_t maxCuts)
{
  this->OpenPieces.assign(1, this->Whole(simplex));
  if (this->CloseAsSame(this->OpenPieces[0]))
  {
    return -Infinity;
  }
  this->Bound(this->OpenPieces[0], Infinity);
  double left = -Infinity;
  const std::int64_t end = this->CutsMade + maxCuts;
  while (!this->OpenPieces.empty() && this->CutsMade < end && !this->ShouldStop())
  {
    Piece piece = this->OpenPieces.back();
    this->OpenPieces.pop_back();
    if (this->Overlay != nullptr && piece.Count == 3 && piece.Depth <= DeepestCover &&
      piece.Depth % CoverPeriod == 0 && piece.Upper > this->ClosingBound())
    {
      this->BoundByCovers(piece, simplex);
    }
    if (piece.Upper <= this->ClosingBound() || piece.Depth == DeepestCut)
    {
      this->MaxClosed = std::max(this->MaxClosed, piece.Upper);
    }
    else
    {
      this->Cut(piece, simplex);
    }
  }
  for (const Piece& piece : this->OpenPieces)
  {
    left = std::max(left, piece.Upper);
  }
  return left;
}

//------------------------------------------------------------------------------
double PieceSearch::UpperOf(Index simplex, std::int64_t maxCuts)
{
  this->MaxFound = MaxExcess();
  this->MaxClosed = -Infinity;
  const Piece whole = this->Whole(simplex);
  for (int i = 0; i < whole.Count; ++i)
  {
    this->UpdateMax(whole.Corners[i], simplex);
  }
  const double left = this->Explore(simplex, maxCuts);
  return std::max(left, this->MaxClosed);
}

//------------------------------------------------------------------------------
Piece PieceSearch::Whole(Index simplex) const
{
  Piece piece;
  piece.Count = this->Source.NumberOfCorners(static_cast<std::size_t>(simplex));
  piece.Depth = 0;
  for (int i = 0; i < piece.Count; ++i)
  {
    const Index point = this->Source.Corners[simplex][i];
    piece.Corners[i] = { this->Source.Points[point],
      this->Source.PointTolerance.empty() ? 0.0 : this->Source.PointTolerance[point],
      this->Values.Value[point], this->Values.Simplex[point], true };
  }
  return piece;
}

//------------------------------------------------------------------------------
/// A simplex that is in both sets has a distance of exactly 0, so no slack is added.
bool PieceSearch::CloseAsSame(const Piece& whole)
{
  Corners positions;
  double leastTolerance = Infinity;
  for (int i = 0; i < whole.Count; ++i)
  {
    const PieceCorner& corner = whole.Corners[i];
    if (!this->TargetSet.HasTolerances() && corner.Value != 0.0)
    {
      return false; // with tolerances the least value may belong to another simplex
    }
    positions[i] = corner.Position;
    leastTolerance = std::min(leastTolerance, corner.Tolerance);
  }
  const Index same = this->TargetSet.FindSame(positions, whole.Count);
  if (same == None)
  {
    return false;
  }
  this->MaxClosed =
    std::max(this->MaxClosed, 0.0 - this->TargetSet.Tolerance(same) - leastTolerance);
  return true;
}

//------------------------------------------------------------------------------
void PieceSearch::Bound(Piece& piece, double parentUpper) const
{
  double most = -Infinity;
  double leastTolerance = Infinity;
  double longest = 0.0;
  for (int i = 0; i < piece.Count; ++i)
  {
    const PieceCorner& corner = piece.Corners[i];
    most = std::max(most, corner.Value);
    leastTolerance = std::min(leastTolerance, corner.Tolerance);
    const PieceCorner& next = piece.Corners[(i + 1) % piece.Count];
    longest = std::max(longest, (next.Position - corner.Position).squaredNorm());
  }
  double upper =
    most + CoveringRatio(piece.Count) * std::sqrt(longest) - leastTolerance + this->Goal.Slack;
  const double goal = this->ClosingBound();
  for (int i = 0; i < piece.Count && upper > goal; ++i)
  {
    const Index candidate = piece.Corners[i].Nearest;
    const bool isKnown = (i > 0 && candidate == piece.Corners[0].Nearest) ||
      (i > 1 && candidate == piece.Corners[1].Nearest);
    upper = isKnown ? upper : std::min(upper, this->UpperOver(piece, candidate, upper));
  }
  piece.Upper = std::min(upper, parentUpper);
}

//------------------------------------------------------------------------------
/// The largest excess over one simplex, or the first one of a corner that is not below the bound.
/// It is reached at a corner, because the distance is convex.
double PieceSearch::UpperOver(const Piece& piece, Index simplex, double bound) const
{
  double upper = -Infinity;
  for (int i = 0; i < piece.Count && upper < bound; ++i)
  {
    upper = std::max(upper, this->UpperAt(piece.Corners[i], simplex));
  }
  return upper;
}

//------------------------------------------------------------------------------
/// Widened by the slack, unless the point is a corner of the simplex: then nothing is rounded.
double PieceSearch::UpperAt(const PieceCorner& corner, Index simplex) const
{
  const double value =
    corner.Nearest == simplex ? corner.Value : this->TargetSet.ValueTo(corner.Position, simplex);
  const bool isSame = corner.IsStored && value == -this->TargetSet.Tolerance(simplex) &&
    this->TargetSet.HasCorner(simplex, corner.Position);
  return value - corner.Tolerance + (isSame ? 0.0 : this->Goal.Slack);
}

//------------------------------------------------------------------------------
void PieceSearch::UpdateMax(const PieceCorner& corner, Index simplex)
{
  const double excess = corner.Value - corner.Tolerance;
  if (excess > this->MaxFound.Value)
  {
    this->MaxFound = { excess, corner.Tolerance, corner.Position, simplex, corner.Nearest };
  }
}

//------------------------------------------------------------------------------
/// Updates the maximum at a position of the piece, moved into it if it is outside by rounding.
/// Returns the nearest simplex.
Index PieceSearch::UpdateMaxNear(
  const Vector3& position, Index hint, const Piece& piece, Index simplex)
{
  PieceCorner corner;
  corner.Position = FindFoot(position, PositionsOf(piece)).Position;
  const Target::Candidate found = this->TargetSet.FindLeast(corner.Position, hint);
  corner.Value = found.Value;
  corner.Nearest = found.Simplex;
  this->UpdateMax(corner, simplex);
  return corner.Nearest;
}

//------------------------------------------------------------------------------
/// First an overlay, with a joint cover of its far parts. If that is not near enough, a joint cover
/// of the whole piece.
void PieceSearch::BoundByCovers(Piece& piece, Index simplex)
{
  const Corners positions = PositionsOf(piece);
  const Triangle nearest = { piece.Corners[0].Nearest, piece.Corners[1].Nearest,
    piece.Corners[2].Nearest };
  if (this->Overlay->Find(positions, nearest, this->Limit()))
  {
    this->BoundByOverlay(piece, simplex);
  }
  if (piece.Upper > this->ClosingBound())
  {
    this->CandidateCover.Begin(this->Goal.Slack);
    this->CandidateCover.Cover(positions.data(), 3);
    const std::vector<Index>& met = this->Overlay->Met();
    for (std::size_t i = 0; i < std::min(met.size(), MaxMet); ++i)
    {
      this->CandidateCover.Add(this->TargetSet.CornersOf(met[i]), met[i]);
    }
    this->BoundJointly(piece, simplex);
  }
}

//------------------------------------------------------------------------------
/// Updates the maximum where the overlay is farthest, and leaves far parts to the joint cover.
void PieceSearch::BoundByOverlay(Piece& piece, Index simplex)
{
  const std::vector<OverlayCover::Part>& parts = this->Overlay->FarParts();
  const auto farthest = std::max_element(
    parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.Upper < b.Upper; });
  if (farthest != parts.end())
  {
    piece.Upper = std::min(piece.Upper, farthest->Upper + this->Goal.Slack);
    this->UpdateMaxNear(farthest->Corners[farthest->Farthest], farthest->Nearest, piece, simplex);
  }
  this->CandidateCover.Begin(this->Goal.Slack);
  this->CandidateCover.Raise(this->Overlay->Upper());
  for (const OverlayCover::Part& part : parts)
  {
    if (part.Upper <= this->Limit())
    {
      this->CandidateCover.Raise(part.Upper);
    }
    else
    {
      this->CandidateCover.Cover(part.Corners.data(), part.Count);
      this->AddWithNeighbors(part.Nearest);
    }
  }
  this->BoundJointly(piece, simplex);
}

//------------------------------------------------------------------------------
/// mm, the largest distance at which a piece is closed.
double PieceSearch::Limit() const
{
  return std::max(0.0, this->ClosingBound() - this->Goal.Slack);
}

//------------------------------------------------------------------------------
/// Lowers the bound of the piece if a few triangles cover it. At a far corner, adds the nearest
/// triangle or raises the limit.
void PieceSearch::BoundJointly(Piece& piece, Index simplex)
{
  for (bool shouldContinue = true; shouldContinue;)
  {
    const double limit = this->Limit();
    const JointCover::Outcome outcome = this->CandidateCover.Run(limit, JointCover::MaxCorners);
    if (outcome == JointCover::Outcome::Covered)
    {
      piece.Upper = std::min(piece.Upper, this->CandidateCover.Upper() + this->Goal.Slack);
    }
    shouldContinue = outcome == JointCover::Outcome::Far &&
      this->AddNearest(this->UpdateMaxNear(this->CandidateCover.FarPosition(),
                         this->CandidateCover.NearestToFar(), piece, simplex),
        limit);
  }
}

//------------------------------------------------------------------------------
/// Adds the nearest triangle and its neighbors to the joint cover. False if neither the candidates
/// nor the limit changed.
bool PieceSearch::AddNearest(Index nearest, double limit)
{
  return this->CandidateCover.Has(nearest) ? this->Limit() > limit
                                           : this->AddWithNeighbors(nearest);
}

//------------------------------------------------------------------------------
/// False if the joint cover has too many candidates.
bool PieceSearch::AddWithNeighbors(Index simplex)
{
  if (!this->CandidateCover.Add(this->TargetSet.CornersOf(simplex), simplex))
  {
    return false;
  }
  for (const Index neighbor : this->TargetSet.Neighbors(simplex))
  {
    if (neighbor >= 0)
    {
      this->CandidateCover.Add(this->TargetSet.CornersOf(neighbor), neighbor);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
PieceCorner PieceSearch::NewCorner(const Piece& piece, const CutWeights& weights) const
{
  const PieceCorner& first = piece.Corners[0];
  PieceCorner corner = first;
  corner.IsStored = false;
  for (int i = 1; i < piece.Count; ++i)
  {
    corner.Position += weights[i] * (piece.Corners[i].Position - first.Position);
    corner.Tolerance += weights[i] * (piece.Corners[i].Tolerance - first.Tolerance);
  }
  const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  corner.Nearest = piece.Corners[nearest].Nearest;
  corner.Value = this->TargetSet.ValueTo(corner.Position, corner.Nearest);
  return corner;
}

//------------------------------------------------------------------------------
PieceSearch::Parts PieceSearch::Divide(
  const Piece& piece, const CutWeights& weights, const PieceCorner& corner) const
{
  Parts parts;
  for (int i = 0; i < piece.Count; ++i)
  {
    if (weights[i] > 0.0)
    {
      Piece& part = parts.Pieces[parts.Count++];
      part = piece;
      part.Corners[i] = corner;
      part.Depth = piece.Depth + 1;
      this->Bound(part, piece.Upper);
      parts.Upper = std::max(parts.Upper, part.Upper);
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
/// Bounds the parts with the candidates known at the corners first. Queries the tree only if that
/// does not close all parts.
void PieceSearch::Cut(const Piece& piece, Index simplex)
{
  ++this->CutsMade;
  const CutWeights weights =
    CutChoice(this->TargetSet, this->ClosingBound(), this->Goal.Slack).Choose(piece);
  PieceCorner corner = this->NewCorner(piece, weights);
  Parts parts = this->Divide(piece, weights, corner);
  if (parts.Upper > this->ClosingBound())
  {
    const Target::Candidate found = this->TargetSet.FindLeast(corner.Position, corner.Nearest);
    corner.Value = found.Value;
    corner.Nearest = found.Simplex;
    this->UpdateMax(corner, simplex);
    parts = this->Divide(piece, weights, corner);
  }
  int worst = 0;
  for (int i = 1; i < parts.Count; ++i)
  {
    worst = parts.Pieces[i].Upper > parts.Pieces[worst].Upper ? i : worst;
  }
  std::swap(parts.Pieces[worst], parts.Pieces[parts.Count - 1]); // popped first
  this->OpenPieces.insert(
    this->OpenPieces.end(), parts.Pieces.begin(), parts.Pieces.begin() + parts.Count);
}
}
