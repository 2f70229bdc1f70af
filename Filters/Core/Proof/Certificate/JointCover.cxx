// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JointCover.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
/// Squared sine of an angle of a candidate; with a sharper one only its sides are looked at.
constexpr double LeastSquaredSine = 1e-18;
/// Candidates are measured in groups of so many, which compilers turn into vector instructions.
constexpr std::size_t Group = 4;

double InverseOf(double squared)
{
  return squared > 0.0 ? 1.0 / squared : 0.0;
}

/// The larger one of x and 0, without a comparison: gcc 12 does not vectorize those.
double Positive(double x)
{
  return 0.5 * (x + std::abs(x));
}

/// The number from 0 to 1 that is nearest to x.
double InUnit(double x)
{
  return 1.0 - Positive(1.0 - Positive(x));
}
}

//------------------------------------------------------------------------------
JointCover::JointCover()
{
  this->Known.reserve(MostCorners);
}

//------------------------------------------------------------------------------
void JointCover::Begin(const Corners& triangle)
{
  this->Count = this->Measured = 0;
  this->SquaredUpper = 0.0;
  this->Known.resize(3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->Known[i].Position = triangle[i];
  }
  this->Open.assign(1, { 0, 1, 2 });
}

//------------------------------------------------------------------------------
bool JointCover::Has(Index id) const
{
  const auto end = this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Count);
  return std::find(this->Ids.begin(), end, id) != end;
}

//------------------------------------------------------------------------------
bool JointCover::Add(const Corners& candidate, Index id)
{
  if (this->Count == MostCandidates || this->Has(id))
  {
    return this->Count < MostCandidates;
  }
  const Vector3 ab = candidate[1] - candidate[0];
  const Vector3 ac = candidate[2] - candidate[0];
  const double bb = ab.squaredNorm();
  const double bc = Dot(ab, ac);
  const double cc = ac.squaredNorm();
  const double determinant = bb * cc - bc * bc;
  this->Ids[this->Count++] = id;
  for (std::size_t i = this->Count - 1; i < this->Groups(); ++i) // the rest of the group repeats it
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      this->A[axis][i] = candidate[0][axis];
      this->AB[axis][i] = ab[axis];
      this->AC[axis][i] = ac[axis];
    }
    this->Bb[i] = bb;
    this->Bc[i] = bc;
    this->Cc[i] = cc;
    this->PerBb[i] = InverseOf(bb);
    this->PerCc[i] = InverseOf(cc);
    this->PerOpposite[i] = InverseOf(bb + cc - 2.0 * bc);
    this->PerDeterminant[i] = determinant > LeastSquaredSine * bb * cc ? 1.0 / determinant : 0.0;
  }
  return true;
}

//------------------------------------------------------------------------------
/// The number of candidates, rounded up to whole groups.
std::size_t JointCover::Groups() const
{
  return (this->Count + Group - 1) / Group * Group;
}

//------------------------------------------------------------------------------
/// Squared distances to the candidates from the first one on: the least of those to the feet on the sides and on the plane. All
/// are moved into the triangle.
void JointCover::Measure(Corner& corner, std::size_t first) const
{
  const double x = corner.Position[0];
  const double y = corner.Position[1];
  const double z = corner.Position[2];
  std::array<PerCandidate<double>, 4> squared; // to the feet
  const std::size_t end = this->Groups();
  for (std::size_t i = first; i < end; ++i)
  {
    const double px = x - this->A[0][i];
    const double py = y - this->A[1][i];
    const double pz = z - this->A[2][i];
    const auto squaredTo = [&](double b, double c)
    {
      const double dx = px - b * this->AB[0][i] - c * this->AC[0][i];
      const double dy = py - b * this->AB[1][i] - c * this->AC[1][i];
      const double dz = pz - b * this->AB[2][i] - c * this->AC[2][i];
      return dx * dx + dy * dy + dz * dz;
    };
    const double bb = this->Bb[i];
    const double bc = this->Bc[i];
    const double cc = this->Cc[i];
    const double pb = this->AB[0][i] * px + this->AB[1][i] * py + this->AB[2][i] * pz;
    const double pc = this->AC[0][i] * px + this->AC[1][i] * py + this->AC[2][i] * pz;
    const double opposite = InUnit((pc - pb + bb - bc) * this->PerOpposite[i]);
    squared[0][i] = squaredTo(InUnit(pb * this->PerBb[i]), 0.0);
    squared[1][i] = squaredTo(0.0, InUnit(pc * this->PerCc[i]));
    squared[2][i] = squaredTo(1.0 - opposite, opposite);
    const double b = InUnit((cc * pb - bc * pc) * this->PerDeterminant[i]);
    const double c = Positive((bb * pc - bc * pb) * this->PerDeterminant[i]);
    squared[3][i] = squaredTo(b, 1.0 - b - Positive(1.0 - b - c));
  }
  for (std::size_t i = first; i < end; ++i)
  {
    corner.Squared[i] = std::min({ squared[0][i], squared[1][i], squared[2][i], squared[3][i] });
  }
}

//------------------------------------------------------------------------------
void JointCover::FindNear(Corner& corner) const
{
  corner.Near = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    corner.Near |= Set(corner.Squared[i] <= this->SquaredLimit ? 1 : 0) << i;
  }
}

//------------------------------------------------------------------------------
JointCover::Outcome JointCover::Run(double limit, std::size_t mostCorners)
{
  this->SquaredLimit = limit * limit;
  for (Corner& corner : this->Known)
  {
    this->Measure(corner, this->Measured);
    this->FindNear(corner);
  }
  this->Measured = this->Count / Group * Group;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (this->Known[i].Near == 0)
    {
      this->FarCorner = this->Known[i];
      return Outcome::Far;
    }
  }
  while (!this->Open.empty())
  {
    const Piece piece = this->Open.back();
    const Set common =
      this->Known[piece[0]].Near & this->Known[piece[1]].Near & this->Known[piece[2]].Near;
    if (common != 0)
    {
      this->Close(piece, common);
      this->Open.pop_back();
    }
    else if (this->Known.size() >= mostCorners)
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
/// Replaces the last open piece by its halves. False if no candidate is near the corner between them.
bool JointCover::Halve(const Piece& piece)
{
  const std::size_t edge = this->EdgeToHalve(piece);
  const std::size_t next = (edge + 1) % 3;
  const std::size_t made = this->Known.size();
  Corner& middle = this->Known.emplace_back();
  const Vector3& from = this->Known[piece[edge]].Position;
  middle.Position = from + 0.5 * (this->Known[piece[next]].Position - from);
  this->Measure(middle, 0);
  this->FindNear(middle);
  if (middle.Near == 0)
  {
    this->FarCorner = middle;
    this->Known.pop_back();
    return false;
  }
  this->Open.back()[next] = made;
  this->Open.push_back(piece);
  this->Open.back()[edge] = made;
  return true;
}

//------------------------------------------------------------------------------
void JointCover::Close(const Piece& piece, Set common)
{
  const PerCandidate<double>& a = this->Known[piece[0]].Squared;
  const PerCandidate<double>& b = this->Known[piece[1]].Squared;
  const PerCandidate<double>& c = this->Known[piece[2]].Squared;
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
    const Corner& from = this->Known[piece[i]];
    const Corner& to = this->Known[piece[(i + 1) % 3]];
    const bool hasCommon = (from.Near & to.Near) != 0;
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
  const auto end = begin + static_cast<std::ptrdiff_t>(this->Count);
  return this->Ids[static_cast<std::size_t>(std::min_element(begin, end) - begin)];
}
}
