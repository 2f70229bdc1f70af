// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSearch.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// How far a point of a triangle of this longest edge, or of such a segment, can be from all corners.
double CoveringShare(int corners)
{
  return corners == 3 ? 0.57735026918962584 : 0.5; // a little more than 1 / sqrt(3)
}
}

//------------------------------------------------------------------------------
PieceSearch::PieceSearch(const Simplices& source, const Target& target, const PointValues& values,
  const SearchGoal& goal, const LargestExcess& largest)
  : Source(source)
  , To(target)
  , Values(values)
  , Wanted(goal)
  , Most(largest)
{
}

//------------------------------------------------------------------------------
double PieceSearch::Goal() const
{
  const double limit = this->Wanted.CloseBelow;
  const double room = this->Wanted.Decides ? 0.0 : 2.0 * this->Wanted.Slack;
  if (this->Most.Value + room <= limit)
  {
    return limit;
  }
  const double gap = std::max(
    this->Wanted.LeastGap, this->Wanted.RelativeGap * (this->Most.Value + this->Wanted.Scale));
  return std::max(limit, this->Most.Value + gap);
}

//------------------------------------------------------------------------------
double PieceSearch::Explore(Index simplex, std::int64_t mostCuts)
{
  this->Stack.assign(1, this->Whole(simplex));
  if (this->CloseAsSame(this->Stack[0]))
  {
    return -Infinity;
  }
  this->Bound(this->Stack[0], Infinity);
  double left = -Infinity;
  const std::int64_t end = this->CutsMade + mostCuts;
  while (!this->Stack.empty() && this->CutsMade < end)
  {
    const Piece piece = this->Stack.back();
    this->Stack.pop_back();
    if (piece.Upper <= this->Goal() || piece.Depth == DeepestCut)
    {
      this->MostClosed = std::max(this->MostClosed, piece.Upper);
    }
    else
    {
      this->Cut(piece, simplex);
    }
  }
  for (const Piece& piece : this->Stack)
  {
    left = std::max(left, piece.Upper);
  }
  return left;
}

//------------------------------------------------------------------------------
double PieceSearch::UpperOf(Index simplex, std::int64_t mostCuts)
{
  this->Most = LargestExcess();
  this->MostClosed = -Infinity;
  const Piece whole = this->Whole(simplex);
  for (int i = 0; i < whole.Count; ++i)
  {
    this->Learn(whole.Corners[i], simplex);
  }
  const double left = this->Explore(simplex, mostCuts);
  return std::max(left, this->MostClosed);
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
/// What stands in both sets with the same coordinates has no distance at all, and needs no slack.
bool PieceSearch::CloseAsSame(const Piece& whole)
{
  Corners places;
  double leastTolerance = Infinity;
  for (int i = 0; i < whole.Count; ++i)
  {
    const PieceCorner& corner = whole.Corners[i];
    if (!this->To.HasTolerances() && corner.Value != 0.0)
    {
      return false; // with tolerances the value is that of a simplex which need not be the same
    }
    places[i] = corner.Place;
    leastTolerance = std::min(leastTolerance, corner.Tolerance);
  }
  const Index same = this->To.FindSame(places, whole.Count);
  if (same == None)
  {
    return false;
  }
  this->MostClosed = std::max(this->MostClosed, 0.0 - this->To.Tolerance(same) - leastTolerance);
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
    longest = std::max(longest, (next.Place - corner.Place).squaredNorm());
  }
  double upper =
    most + CoveringShare(piece.Count) * std::sqrt(longest) - leastTolerance + this->Wanted.Slack;
  const double goal = this->Goal();
  for (int i = 0; i < piece.Count && upper > goal; ++i)
  {
    const Index candidate = piece.Corners[i].Nearest;
    const bool isKnown = (i > 0 && candidate == piece.Corners[0].Nearest) ||
      (i > 1 && candidate == piece.Corners[1].Nearest);
    upper = isKnown ? upper : std::min(upper, this->UpperOver(piece, candidate));
  }
  piece.Upper = std::min(upper, parentUpper);
}

//------------------------------------------------------------------------------
/// The largest excess over one simplex: it is at a corner.
double PieceSearch::UpperOver(const Piece& piece, Index simplex) const
{
  double upper = -Infinity;
  for (int i = 0; i < piece.Count; ++i)
  {
    upper = std::max(upper, this->UpperAt(piece.Corners[i], simplex));
  }
  return upper;
}

//------------------------------------------------------------------------------
/// Widened by the slack, unless the corner is one of the simplex: nothing was computed then.
double PieceSearch::UpperAt(const PieceCorner& corner, Index simplex) const
{
  const double value =
    corner.Nearest == simplex ? corner.Value : this->To.ValueTo(corner.Place, simplex);
  const bool isSame = corner.IsGiven && value == -this->To.Tolerance(simplex) &&
    this->To.HasCorner(simplex, corner.Place);
  return value - corner.Tolerance + (isSame ? 0.0 : this->Wanted.Slack);
}

//------------------------------------------------------------------------------
void PieceSearch::Learn(const PieceCorner& corner, Index simplex)
{
  const double excess = corner.Value - corner.Tolerance;
  if (excess > this->Most.Value)
  {
    this->Most = { excess, corner.Tolerance, corner.Place, simplex, corner.Nearest };
  }
}

//------------------------------------------------------------------------------
PieceCorner PieceSearch::NewCorner(const Piece& piece, const CutWeights& weights) const
{
  const PieceCorner& first = piece.Corners[0];
  PieceCorner corner = first;
  corner.IsGiven = false;
  for (int i = 1; i < piece.Count; ++i)
  {
    corner.Place += weights[i] * (piece.Corners[i].Place - first.Place);
    corner.Tolerance += weights[i] * (piece.Corners[i].Tolerance - first.Tolerance);
  }
  const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  corner.Nearest = piece.Corners[nearest].Nearest;
  corner.Value = this->To.ValueTo(corner.Place, corner.Nearest);
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
/// First with what is known of a corner; the tree is asked only if that does not close all parts.
void PieceSearch::Cut(const Piece& piece, Index simplex)
{
  ++this->CutsMade;
  const CutWeights weights = CutChoice(this->To, this->Goal(), this->Wanted.Slack).Choose(piece);
  PieceCorner corner = this->NewCorner(piece, weights);
  Parts parts = this->Divide(piece, weights, corner);
  if (parts.Upper > this->Goal())
  {
    const Target::Candidate found = this->To.FindLeast(corner.Place, corner.Nearest);
    corner.Value = found.Value;
    corner.Nearest = found.Simplex;
    this->Learn(corner, simplex);
    parts = this->Divide(piece, weights, corner);
  }
  int worst = 0;
  for (int i = 1; i < parts.Count; ++i)
  {
    worst = parts.Pieces[i].Upper > parts.Pieces[worst].Upper ? i : worst;
  }
  std::swap(parts.Pieces[worst], parts.Pieces[parts.Count - 1]); // looked at first
  this->Stack.insert(this->Stack.end(), parts.Pieces.begin(), parts.Pieces.begin() + parts.Count);
}
}
