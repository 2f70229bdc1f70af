// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommonFaceProof.h"

#include "ErrorLimits.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Least squared sine of an angle of a triangle. Sharper ones have no useful plane, only sides.
constexpr double MinSquaredSine = 1e-18;
/// Splits nearer to an end of the edge than this fraction gain too little.
constexpr double MinFraction = 0.02;

/// If a weight is nearer to zero than this, the point is on the side of the face.
constexpr double OnSide = 1e-9;

/// Fraction at which a weight that falls from the first to the second value reaches zero. 1 if it
/// ends inside.
double ZeroOf(double first, double second)
{
  return second >= -OnSide ? 1.0 : first > 0.0 ? first / (first - second) : 0.0;
}
}

CommonFaceProof::CommonFaceProof()
  : Compute(BestKernels())
{
}

//------------------------------------------------------------------------------
void CommonFaceProof::AddCandidate(const std::array<Vector3, 3>& corners, double maxDistance)
{
  const Vector3 ab = corners[1] - corners[0];
  const Vector3 ac = corners[2] - corners[0];
  const double bb = ab.squaredNorm();
  const double bc = Dot(ab, ac);
  const double cc = ac.squaredNorm();
  const double determinant = bb * cc - bc * bc;
  const std::array<double, 3> squared = { bb, cc, bb + cc - 2.0 * bc };
  TriangleBatch& batch = this->Candidates[this->Count / TriangleBatch::Size];
  const std::size_t from = this->Count % TriangleBatch::Size;
  for (std::size_t lane = from; lane < TriangleBatch::Size; ++lane) // free lanes repeat it
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
    batch.PerDeterminant[lane] = determinant > MinSquaredSine * bb * cc ? 1.0 / determinant : 0.0;
  }
  this->MaxDistances[this->Count++] = maxDistance;
}

//------------------------------------------------------------------------------
CommonFaceProof::Faces CommonFaceProof::FacesNear(const Vector3& p, double limit)
{
  const std::size_t batches = (this->Count + TriangleBatch::Size - 1) / TriangleBatch::Size;
  this->Compute.ReachTriangles(
    this->Candidates.data(), static_cast<int>(batches), p.data(), this->SquaredDistances.data());
  Faces near = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const double maxDistance = std::min(limit, this->MaxDistances[i]);
    near |= Faces(this->SquaredDistances[i] <= maxDistance * maxDistance ? 1 : 0) << i;
  }
  return near;
}

//------------------------------------------------------------------------------
/// Barycentric weights of the foot of p on the plane of the candidate, inside or outside.
std::array<double, 3> CommonFaceProof::Weights(std::size_t candidate, const Vector3& p) const
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
CommonFaceResult CommonFaceProof::Prove(const Piece& whole, Faces& used, std::size_t maxPieces)
{
  if (std::any_of(
        whole.begin(), whole.end(), [this](const Corner& corner) { return this->IsFar(corner); }))
  {
    return CommonFaceResult::TooFar;
  }
  this->OpenPieces.assign(1, whole);
  for (std::size_t at = 0; at < this->OpenPieces.size(); ++at)
  {
    const Piece piece = this->OpenPieces[at];
    const Faces shared =
      piece[0].NearCandidates & piece[1].NearCandidates & piece[2].NearCandidates;
    if (shared == 0 && this->OpenPieces.size() + 2 > maxPieces)
    {
      return CommonFaceResult::Unknown;
    }
    if (shared == 0 && !this->Split(piece))
    {
      return CommonFaceResult::TooFar;
    }
    if ((shared & used) == 0)
    {
      used |= shared & (~shared + 1); // the lowest, if any
    }
  }
  return CommonFaceResult::Proved;
}

//------------------------------------------------------------------------------
bool CommonFaceProof::IsFar(const Corner& corner)
{
  if (corner.NearCandidates == 0)
  {
    this->FarPoint = corner.Position;
  }
  return corner.NearCandidates == 0;
}

//------------------------------------------------------------------------------
/// Adds both halves to the open pieces; false if no candidate is near the point between them.
bool CommonFaceProof::Split(const Piece& piece)
{
  std::size_t edge = 0;
  bool edgeHasCommon = true;
  double longest = -1.0; // mm^2, among the edges without a common face, if there are any
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Corner& from = piece[i];
    const Corner& to = piece[(i + 1) % 3];
    const bool hasCommon = (from.NearCandidates & to.NearCandidates) != 0;
    const double length = (to.Position - from.Position).squaredNorm();
    if ((edgeHasCommon && !hasCommon) || (hasCommon == edgeHasCommon && length > longest))
    {
      edge = i;
      edgeHasCommon = hasCommon;
      longest = length;
    }
  }
  const double at = edgeHasCommon ? 0.5 : this->ExitFraction(piece[edge], piece[(edge + 1) % 3]);
  const Corner middle = this->Between(piece[edge], piece[(edge + 1) % 3], at);
  if (this->IsFar(middle))
  {
    return false;
  }
  this->OpenPieces.push_back(piece);
  this->OpenPieces.back()[(edge + 1) % 3] = middle;
  this->OpenPieces.push_back(piece);
  this->OpenPieces.back()[edge] = middle;
  return true;
}

//------------------------------------------------------------------------------
CommonFaceProof::Corner CommonFaceProof::Between(const Corner& from, const Corner& to, double t)
{
  Corner middle;
  middle.Position = from.Position + t * (to.Position - from.Position);
  middle.Limit = ErrorLimits::Interpolate(from.Limit, to.Limit, t);
  middle.NearCandidates = this->FacesNear(middle.Position, middle.Limit);
  return middle;
}

//------------------------------------------------------------------------------
/// The largest fraction of the edge over one face near its start; 0.5 if that is too near to an
/// end.
double CommonFaceProof::ExitFraction(const Corner& from, const Corner& to) const
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    if ((from.NearCandidates >> i & 1) != 0)
    {
      const std::array<double, 3> start = this->Weights(i, from.Position);
      const std::array<double, 3> end = this->Weights(i, to.Position);
      farthest = std::max(farthest,
        std::min({ ZeroOf(start[0], end[0]), ZeroOf(start[1], end[1]), ZeroOf(start[2], end[2]) }));
    }
  }
  return farthest > MinFraction && farthest < 1.0 - MinFraction ? farthest : 0.5;
}
}
