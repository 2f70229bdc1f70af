// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutChoice.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
/// From this depth on, every third cut halves the longest edge, so that pieces shrink whatever the
/// candidates are.
constexpr int FirstHalving = 12;
/// Size of a piece after about four cuts, as a fraction of the longest edge.
constexpr double LengthRatioAfterFewCuts = 0.15;
constexpr int HalvingPeriod = 3;
/// A vertex with a larger barycentric weight coincides with the corner.
constexpr double MaxWeight = 1.0 - 1e-6;
/// A cut nearer to an end than this fraction of the edge makes slivers: the edge is halved instead.
constexpr double MinFraction = 1.0 / 32.0;
constexpr int MaxSecants = 6;
/// Values of two candidates count as equal if they differ by less than this fraction of their
/// distance to the closing bound.
constexpr double EqualEnough = 0.05;

}

//------------------------------------------------------------------------------
CutWeights CutChoice::Choose(const Piece& piece) const
{
  const Edge longest = LongestEdge(piece);
  const bool halve = piece.Depth >= FirstHalving && piece.Depth % HalvingPeriod == 0;
  if (halve || this->ClosesBySize(piece, std::sqrt(longest.SquaredLength)))
  {
    return OnEdge(longest, 0.5);
  }
  if (const std::optional<CutWeights> vertex = this->CommonVertex(piece))
  {
    return *vertex;
  }
  const Edge unshared = this->LongestUnsharedEdge(piece);
  return unshared.SquaredLength < 0.0 ? OnEdge(longest, 0.5)
                                      : OnEdge(unshared, this->EqualFraction(piece, unshared));
}

//------------------------------------------------------------------------------
CutChoice::Edge CutChoice::EdgeOf(const Piece& piece, int from)
{
  Edge edge;
  edge.From = from;
  edge.To = (from + 1) % piece.Count;
  edge.SquaredLength =
    (piece.Corners[edge.To].Position - piece.Corners[edge.From].Position).squaredNorm();
  return edge;
}

//------------------------------------------------------------------------------
CutChoice::Edge CutChoice::LongestEdge(const Piece& piece)
{
  Edge longest = EdgeOf(piece, 0);
  for (int i = 1; i < NumberOfEdges(piece); ++i)
  {
    const Edge edge = EdgeOf(piece, i);
    longest = edge.SquaredLength > longest.SquaredLength ? edge : longest;
  }
  return longest;
}

//------------------------------------------------------------------------------
/// Whether a few cuts, wherever they are, make the pieces so small that they are closed by their
/// size.
bool CutChoice::ClosesBySize(const Piece& piece, double longest) const
{
  double most = -Infinity;
  double leastTolerance = Infinity;
  for (int i = 0; i < piece.Count; ++i)
  {
    most = std::max(most, piece.Corners[i].Value);
    leastTolerance = std::min(leastTolerance, piece.Corners[i].Tolerance);
  }
  return most + LengthRatioAfterFewCuts * longest - leastTolerance <= this->ClosingBound;
}

//------------------------------------------------------------------------------
CutChoice::Edge CutChoice::LongestUnsharedEdge(const Piece& piece) const
{
  Edge longest;
  for (int i = 0; i < NumberOfEdges(piece); ++i)
  {
    Edge edge = EdgeOf(piece, i);
    if (edge.SquaredLength > longest.SquaredLength && this->IsUnshared(piece, edge))
    {
      longest = edge;
    }
  }
  return longest;
}

//------------------------------------------------------------------------------
CutWeights CutChoice::OnEdge(const Edge& edge, double fraction)
{
  CutWeights weights = { 0.0, 0.0, 0.0 };
  weights[edge.To] = fraction;
  weights[edge.From] = 1.0 - fraction;
  return weights;
}

//------------------------------------------------------------------------------
std::optional<CutWeights> CutChoice::CommonVertex(const Piece& piece) const
{
  const auto& [a, b, c] = piece.Corners;
  for (int i = 0; i < 3 && piece.Count == 3; ++i)
  {
    const Index one = piece.Corners[i].Nearest;
    const Index other = piece.Corners[(i + 1) % 3].Nearest;
    const Corners ofOne = this->TargetSet.CornersOf(one);
    const Corners ofOther = this->TargetSet.CornersOf(other);
    for (std::size_t k = 0; k < 3 && one != other; ++k)
    {
      if (std::find(ofOther.begin(), ofOther.end(), ofOne[k]) == ofOther.end())
      {
        continue;
      }
      const CutWeights weights =
        NearestOnTriangle(ofOne[k], a.Position, b.Position, c.Position).Weights;
      const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
      if (*least > 0.0 && *most < MaxWeight)
      {
        return weights;
      }
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Also stores the value of each end to the candidate of the other end.
bool CutChoice::IsUnshared(const Piece& piece, Edge& edge) const
{
  const PieceCorner& from = piece.Corners[edge.From];
  const PieceCorner& to = piece.Corners[edge.To];
  if (from.Nearest == to.Nearest)
  {
    return false;
  }
  edge.FromToOther = this->TargetSet.ValueTo(from.Position, to.Nearest);
  edge.ToToOther = this->TargetSet.ValueTo(to.Position, from.Nearest);
  const double goal = this->ClosingBound - this->Slack;
  return edge.FromToOther - from.Tolerance > goal && edge.ToToOther - to.Tolerance > goal;
}

//------------------------------------------------------------------------------
/// Regula falsi, Illinois variant.
double CutChoice::EqualFraction(const Piece& piece, const Edge& edge) const
{
  const PieceCorner& from = piece.Corners[edge.From];
  const PieceCorner& to = piece.Corners[edge.To];
  const auto difference = [&](double fraction)
  {
    const Vector3 position = from.Position + fraction * (to.Position - from.Position);
    return this->TargetSet.ValueTo(position, from.Nearest) -
      this->TargetSet.ValueTo(position, to.Nearest);
  };
  const double sufficient =
    EqualEnough * (this->ClosingBound - this->Slack - std::min(from.Value, to.Value));
  double low = 0.0;
  double high = 1.0;
  double atLow = from.Value - edge.FromToOther;
  double atHigh = edge.ToToOther - to.Value;
  double fraction = 0.5;
  int side = 0; // sign at the previous fraction
  for (int i = 0; i < MaxSecants && atLow < 0.0 && atHigh > 0.0; ++i)
  {
    fraction = low - atLow * (high - low) / (atHigh - atLow);
    const double here = difference(fraction);
    if (std::abs(here) <= sufficient)
    {
      break;
    }
    const int sideHere = here < 0.0 ? -1 : 1;
    (sideHere < 0 ? low : high) = fraction;
    (sideHere < 0 ? atLow : atHigh) = here;
    (sideHere < 0 ? atHigh : atLow) *= sideHere == side ? 0.5 : 1.0;
    side = sideHere;
  }
  return fraction > MinFraction && fraction < 1.0 - MinFraction ? fraction : 0.5;
}
}
