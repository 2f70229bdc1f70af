// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JointCover.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
/// Candidates are measured in groups of this size, which compilers vectorize.
constexpr std::size_t GroupSize = 4;

/// mm^2; the squares of shorter lengths underflow, and the slack is longer (Foot.h).
constexpr double MinSquared = 1e-300;

/// A vector of length 1; any such vector across the axis if there is only rounding error.
Vector3 Across(const Vector3& axis, const Vector3& from)
{
  const Vector3 first = from - Dot(axis, from) * axis;
  const Vector3 second = first - Dot(axis, first) * axis;
  if (second.squaredNorm() > std::max(MinSquared, 0.5 * first.squaredNorm()))
  {
    return second.normalized();
  }
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vector3::Unit(least)).normalized();
}

/// The larger one of x and 0, without a comparison: gcc 12 does not vectorize those.
double Positive(double x)
{
  return 0.5 * (x + std::abs(x));
}
}

//------------------------------------------------------------------------------
JointCover::JointCover()
{
  this->PieceCorners.reserve(MaxCorners);
}

//------------------------------------------------------------------------------
void JointCover::Begin(double slack)
{
  this->Margin = slack;
  this->NumberOfCandidates = this->MeasuredCandidates = this->InitialCorners = 0;
  this->SquaredUpper = 0.0;
  this->PieceCorners.clear();
  this->OpenPieces.clear();
}

//------------------------------------------------------------------------------
void JointCover::Cover(const Vector3* corners, std::size_t count)
{
  const std::size_t first = this->PieceCorners.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    this->PieceCorners.emplace_back().Position = corners[i];
    if (i > 1)
    {
      this->OpenPieces.push_back({ first, first + i - 1, first + i });
    }
  }
  this->InitialCorners = this->PieceCorners.size();
}

//------------------------------------------------------------------------------
void JointCover::Raise(double upper)
{
  this->SquaredUpper = std::max(this->SquaredUpper, upper * upper);
}

//------------------------------------------------------------------------------
bool JointCover::Has(Index id) const
{
  const auto end = this->Ids.begin() + static_cast<std::ptrdiff_t>(this->NumberOfCandidates);
  return std::find(this->Ids.begin(), end, id) != end;
}

//------------------------------------------------------------------------------
bool JointCover::Add(const Corners& candidate, Index id)
{
  if (this->NumberOfCandidates == MaxCandidates || this->Has(id))
  {
    return this->NumberOfCandidates < MaxCandidates;
  }
  const Vector3 ab = candidate[1] - candidate[0];
  const Vector3 ac = candidate[2] - candidate[0];
  const Vector3& longer = ab.squaredNorm() > MinSquared ? ab : ac;
  const Vector3 u =
    longer.squaredNorm() > MinSquared ? Vector3(longer.normalized()) : Vector3(Vector3::UnitX());
  const Vector3 v = Across(u, ac);
  const Vector3 w = u.cross(v);
  const double bAlong = Dot(u, ab);
  const double cAlong = Dot(u, ac);
  const double cAcross = Dot(v, ac);
  struct Side
  {
    double FromU, FromV, ToU, ToV;
  };
  const std::array<Side, 3> sides = { Side{ 0.0, 0.0, bAlong, 0.0 },
    { bAlong, 0.0, cAlong, cAcross }, { cAlong, cAcross, 0.0, 0.0 } };
  this->Ids[this->NumberOfCandidates++] = id;
  for (std::size_t i = this->NumberOfCandidates - 1; i < this->RoundedCount();
       ++i) // the rest of the group repeats it
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      this->A[axis][i] = candidate[0][axis];
      this->U[axis][i] = u[axis];
      this->V[axis][i] = v[axis];
      this->W[axis][i] = w[axis];
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Side& side = sides[k];
      const double du = side.ToU - side.FromU;
      const double dv = side.ToV - side.FromV;
      const double squared = du * du + dv * dv;
      const double length = squared > MinSquared ? std::sqrt(squared) : 0.0;
      const double alongU = length > 0.0 ? du / length : (k == 1 ? -1.0 : 1.0); // nothing is inside
      const double alongV = length > 0.0 ? dv / length : 0.0;
      this->AlongU[k][i] = alongU;
      this->AlongV[k][i] = alongV;
      this->MiddleAlong[k][i] = alongU * side.FromU + alongV * side.FromV + 0.5 * length;
      this->HalfLength[k][i] = 0.5 * length;
      this->OffsetAcross[k][i] = alongU * side.FromV - alongV * side.FromU;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// The number of candidates, rounded up to whole groups.
std::size_t JointCover::RoundedCount() const
{
  return (this->NumberOfCandidates + GroupSize - 1) / GroupSize * GroupSize;
}

//------------------------------------------------------------------------------
/// Squared distances to the candidates from the first one on. In the plane of a candidate, to the
/// nearest side, or none if the foot is on the inner side of all three.
void JointCover::Measure(Corner& corner, std::size_t first) const
{
  const double x = corner.Position[0];
  const double y = corner.Position[1];
  const double z = corner.Position[2];
  PerCandidate<double> height, outside;
  std::array<PerCandidate<double>, 3> squared; // to the sides, in the plane
  const std::size_t end = this->RoundedCount();
  for (std::size_t i = first; i < end; ++i)
  {
    const double px = x - this->A[0][i];
    const double py = y - this->A[1][i];
    const double pz = z - this->A[2][i];
    const double u = this->U[0][i] * px + this->U[1][i] * py + this->U[2][i] * pz;
    const double v = this->V[0][i] * px + this->V[1][i] * py + this->V[2][i] * pz;
    const double w = this->W[0][i] * px + this->W[1][i] * py + this->W[2][i] * pz;
    height[i] = w * w;
    double out = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double along = this->AlongU[k][i] * u + this->AlongV[k][i] * v;
      const double beyond =
        Positive(std::abs(along - this->MiddleAlong[k][i]) - this->HalfLength[k][i]);
      const double inward =
        this->AlongU[k][i] * v - this->AlongV[k][i] * u - this->OffsetAcross[k][i];
      squared[k][i] = beyond * beyond + inward * inward;
      out += Positive(this->Margin - inward);
    }
    outside[i] = out;
  }
  for (std::size_t i = first; i < end; ++i)
  {
    const double toSide = std::min({ squared[0][i], squared[1][i], squared[2][i] });
    corner.Squared[i] = height[i] + (outside[i] > 0.0 ? toSide : 0.0);
  }
}

//------------------------------------------------------------------------------
void JointCover::FindNear(Corner& corner) const
{
  corner.NearCandidates = 0;
  for (std::size_t i = 0; i < this->NumberOfCandidates; ++i)
  {
    corner.NearCandidates |= CandidateSet(corner.Squared[i] <= this->SquaredLimit ? 1 : 0) << i;
  }
}

//------------------------------------------------------------------------------
JointCover::Outcome JointCover::Run(double limit, std::size_t maxCorners)
{
  this->SquaredLimit = limit * limit;
  for (Corner& corner : this->PieceCorners)
  {
    this->Measure(corner, this->MeasuredCandidates);
    this->FindNear(corner);
  }
  this->MeasuredCandidates = this->NumberOfCandidates / GroupSize * GroupSize;
  for (std::size_t i = 0; i < this->InitialCorners; ++i)
  {
    if (this->PieceCorners[i].NearCandidates == 0)
    {
      this->FarCorner = this->PieceCorners[i];
      return Outcome::Far;
    }
  }
  while (!this->OpenPieces.empty())
  {
    const Piece piece = this->OpenPieces.back();
    const CandidateSet common = this->PieceCorners[piece[0]].NearCandidates &
      this->PieceCorners[piece[1]].NearCandidates & this->PieceCorners[piece[2]].NearCandidates;
    if (common != 0)
    {
      this->Close(piece, common);
      this->OpenPieces.pop_back();
    }
    else if (this->PieceCorners.size() >= maxCorners)
    {
      return Outcome::Exceeded;
    }
    else if (!this->Halve(piece))
    {
      return Outcome::Far;
    }
  }
  return Outcome::Covered;
}

//------------------------------------------------------------------------------
/// Replaces the last open piece by its halves. False if no candidate is near the corner between
/// them.
bool JointCover::Halve(const Piece& piece)
{
  const std::size_t edge = this->EdgeToHalve(piece);
  const std::size_t next = (edge + 1) % 3;
  const std::size_t made = this->PieceCorners.size();
  Corner& middle = this->PieceCorners.emplace_back();
  const Vector3& from = this->PieceCorners[piece[edge]].Position;
  middle.Position = from + 0.5 * (this->PieceCorners[piece[next]].Position - from);
  this->Measure(middle, 0);
  this->FindNear(middle);
  if (middle.NearCandidates == 0)
  {
    this->FarCorner = middle;
    this->PieceCorners.pop_back();
    return false;
  }
  this->OpenPieces.back()[next] = made;
  this->OpenPieces.push_back(piece);
  this->OpenPieces.back()[edge] = made;
  return true;
}

//------------------------------------------------------------------------------
void JointCover::Close(const Piece& piece, CandidateSet common)
{
  const PerCandidate<double>& a = this->PieceCorners[piece[0]].Squared;
  const PerCandidate<double>& b = this->PieceCorners[piece[1]].Squared;
  const PerCandidate<double>& c = this->PieceCorners[piece[2]].Squared;
  double least = this->SquaredLimit;
  for (std::size_t i = 0; common != 0; ++i, common >>= 1)
  {
    if ((common & 1) != 0)
    {
      least = std::min(least, std::max({ a[i], b[i], c[i] }));
    }
  }
  this->SquaredUpper = std::max(this->SquaredUpper, least);
}

//------------------------------------------------------------------------------
std::size_t JointCover::EdgeToHalve(const Piece& piece) const
{
  std::size_t edge = 0;
  bool edgeHasCommon = true;
  double longest = -1.0; // mm^2
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Corner& from = this->PieceCorners[piece[i]];
    const Corner& to = this->PieceCorners[piece[(i + 1) % 3]];
    const bool hasCommon = (from.NearCandidates & to.NearCandidates) != 0;
    const double length = (to.Position - from.Position).squaredNorm();
    if ((edgeHasCommon && !hasCommon) || (hasCommon == edgeHasCommon && length > longest))
    {
      edge = i;
      edgeHasCommon = hasCommon;
      longest = length;
    }
  }
  return edge;
}

//------------------------------------------------------------------------------
double JointCover::Upper() const
{
  return std::sqrt(this->SquaredUpper);
}

//------------------------------------------------------------------------------
Index JointCover::NearestToFar() const
{
  const auto begin = this->FarCorner.Squared.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(this->NumberOfCandidates);
  return this->Ids[static_cast<std::size_t>(std::min_element(begin, end) - begin)];
}
}
