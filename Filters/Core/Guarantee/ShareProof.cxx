// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShareProof.h"

#include "Limits.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Pieces looked at before an edit is refused: with too few, good edits are.
constexpr int MostPieces = 256;
/// Of a triangle's angle: sharper ones have no plane worth the name, only sides.
constexpr double LeastSquaredSine = 1e-18;
/// Splits nearer to an end of the edge than that share gain too little.
constexpr double LeastFraction = 0.02;

/// Where a weight that falls from the first to the second value reaches zero; 1 if it does not.
double ZeroOf(double first, double second)
{
  return second < 0.0 && first > 0.0 ? first / (first - second) : first < 0.0 ? 0.0 : 1.0;
}
}

ShareProof::ShareProof()
  : Compute(BestKernels())
{
}

//------------------------------------------------------------------------------
void ShareProof::AddCandidate(const std::array<Vector3, 3>& corners)
{
  const Vector3 ab = corners[1] - corners[0];
  const Vector3 ac = corners[2] - corners[0];
  const double bb = ab.squaredNorm();
  const double bc = ab.dot(ac);
  const double cc = ac.squaredNorm();
  const double determinant = bb * cc - bc * bc;
  const std::array<double, 3> squared = { bb, cc, bb + cc - 2.0 * bc };
  TriangleBatch& batch = this->Candidates[this->Count / TriangleBatch::Size];
  const std::size_t from = this->Count % TriangleBatch::Size;
  for (std::size_t lane = from; lane < TriangleBatch::Size; ++lane) // the free ones repeat it
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      batch.A[axis][lane] = corners[0][axis];
      batch.AB[axis][lane] = ab[axis];
      batch.AC[axis][lane] = ac[axis];
      batch.PerSquared[axis][lane] = squared[axis] > 0.0 ? 1.0 / squared[axis] : 0.0;
    }
    batch.Bb[lane] = bb;
    batch.Bc[lane] = bc;
    batch.Cc[lane] = cc;
    batch.PerDeterminant[lane] = determinant > LeastSquaredSine * bb * cc ? 1.0 / determinant : 0.0;
  }
  ++this->Count;
}

//------------------------------------------------------------------------------
ShareProof::Faces ShareProof::FacesNear(const Vector3& p, double limit)
{
  const std::size_t batches = (this->Count + TriangleBatch::Size - 1) / TriangleBatch::Size;
  this->Compute.ReachTriangles(
    this->Candidates.data(), static_cast<int>(batches), p.data(), this->Squared.data());
  Faces near = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    near |= Faces(this->Squared[i] <= limit * limit ? 1 : 0) << i;
  }
  return near;
}

//------------------------------------------------------------------------------
/// Of the foot of p on the plane, inside or out.
std::array<double, 3> ShareProof::Weights(std::size_t candidate, const Vector3& p) const
{
  const TriangleBatch& batch = this->Candidates[candidate / TriangleBatch::Size];
  const std::size_t i = candidate % TriangleBatch::Size;
  double pb = 0.0;
  double pc = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    pb += batch.AB[axis][i] * (p[axis] - batch.A[axis][i]);
    pc += batch.AC[axis][i] * (p[axis] - batch.A[axis][i]);
  }
  const double b = (batch.Cc[i] * pb - batch.Bc[i] * pc) * batch.PerDeterminant[i];
  const double c = (batch.Bb[i] * pc - batch.Bc[i] * pb) * batch.PerDeterminant[i];
  return { 1.0 - b - c, b, c };
}

//------------------------------------------------------------------------------
bool ShareProof::Prove(const Piece& whole, Faces& used)
{
  this->Open.assign(1, whole);
  for (int pieces = 0; !this->Open.empty(); ++pieces)
  {
    const Piece piece = this->Open.back();
    this->Open.pop_back();
    if (pieces == MostPieces || piece[0].Near == 0 || piece[1].Near == 0 || piece[2].Near == 0)
    {
      return false;
    }
    const Faces shared = piece[0].Near & piece[1].Near & piece[2].Near;
    if (shared == 0)
    {
      const std::array<Piece, 2> halves = this->Split(piece);
      this->Open.insert(this->Open.end(), halves.begin(), halves.end());
    }
    else if ((shared & used) == 0)
    {
      used |= shared & (~shared + 1); // the lowest
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::array<ShareProof::Piece, 2> ShareProof::Split(const Piece& piece)
{
  std::size_t edge = 0;
  double longest = -1.0; // mm^2; an edge without a shared face goes before all others
  double at = 0.5;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Corner& from = piece[i];
    const Corner& to = piece[(i + 1) % 3];
    const bool shares = (from.Near & to.Near) != 0;
    const double length = (to.Place - from.Place).squaredNorm();
    if (!shares)
    {
      edge = i;
      at = this->ExitFraction(from, to);
      break;
    }
    if (length > longest)
    {
      longest = length;
      edge = i;
    }
  }
  const Corner middle = this->Between(piece[edge], piece[(edge + 1) % 3], at);
  std::array<Piece, 2> halves = { piece, piece };
  halves[0][(edge + 1) % 3] = middle;
  halves[1][edge] = middle;
  return halves;
}

//------------------------------------------------------------------------------
ShareProof::Corner ShareProof::Between(const Corner& from, const Corner& to, double t)
{
  Corner middle;
  middle.Place = from.Place + t * (to.Place - from.Place);
  middle.Limit = Limits::Between(from.Limit, to.Limit, t);
  middle.Near = this->FacesNear(middle.Place, middle.Limit);
  return middle;
}

//------------------------------------------------------------------------------
/// The farthest that a face near the start lies below the edge; the middle if that is too near to an end.
double ShareProof::ExitFraction(const Corner& from, const Corner& to) const
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    if ((from.Near >> i & 1) != 0)
    {
      const std::array<double, 3> start = this->Weights(i, from.Place);
      const std::array<double, 3> end = this->Weights(i, to.Place);
      farthest = std::max(farthest,
        std::min({ ZeroOf(start[0], end[0]), ZeroOf(start[1], end[1]), ZeroOf(start[2], end[2]) }));
    }
  }
  return farthest > LeastFraction && farthest < 1.0 - LeastFraction ? farthest : 0.5;
}
}
