// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceProof.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Largest number of pieces of one face.
constexpr std::size_t MaxPiecesOfFace = 256;
/// After this many halvings a piece usually has few enough original triangles near it for
/// CommonFaceProof.
constexpr int HalvingsBeforeCommonFaces = 2;
/// Pieces that CommonFaceProof may make of a piece.
constexpr std::size_t MaxPartsOfPiece = 128;
constexpr Index MaxNearTriangles = CommonFaceProof::MaxCandidates;
}

//------------------------------------------------------------------------------
bool FaceProof::Prove(const WalkedSurface& target, const std::array<Vector3, 3>& face, Index hint)
{
  this->OpenPieces.assign(1, { face, hint, 0 });
  for (std::size_t at = 0; at < this->OpenPieces.size(); ++at)
  {
    const Piece piece = this->OpenPieces[at];
    if (at >= MaxPiecesOfFace || !this->ProvePiece(target, piece))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Proves the piece or queues its halves; false if a point is too far away.
bool FaceProof::ProvePiece(const WalkedSurface& target, const Piece& piece)
{
  const auto limit = [&target](Index id) { return target.Limit(id); };
  if (piece.Halvings == 0 && this->Planes.Prove(piece.Corners, piece.Hint, limit))
  {
    return true;
  }
  const Vector3 middle = (piece.Corners[0] + piece.Corners[1] + piece.Corners[2]) / 3.0;
  const PieceCover<3>::Corner nearest = target.Find(middle, piece.Hint);
  if (!target.IsWithin(nearest))
  {
    return false;
  }
  // The distance to a triangle is a convex function.
  const auto isWithin = [&](const Vector3& corner)
  { return target.Distance(corner, nearest.Nearest) <= target.Limit(nearest.Nearest); };
  if (std::all_of(piece.Corners.begin(), piece.Corners.end(), isWithin) ||
    this->Planes.Prove(piece.Corners, nearest.Nearest, limit))
  {
    return true;
  }
  if (!target.IsWithin(target.Find(this->Planes.SuspectPosition(), nearest.Nearest)))
  {
    return false;
  }
  if (piece.Halvings >= HalvingsBeforeCommonFaces)
  {
    const CommonFaceResult result = this->ProveTogether(target, piece, nearest.Nearest);
    if (result == CommonFaceResult::Proved)
    {
      return true;
    }
    if (result == CommonFaceResult::TooFar &&
      !target.IsWithin(target.Find(this->CommonFaces.FarPosition(), nearest.Nearest)))
    {
      return false;
    }
  }
  this->Halve(piece, nearest.Nearest);
  return true;
}

//------------------------------------------------------------------------------
CommonFaceResult FaceProof::ProveTogether(
  const WalkedSurface& target, const Piece& piece, Index seed)
{
  if (!this->GatherNear(target, piece, seed))
  {
    return CommonFaceResult::Unknown;
  }
  this->CommonFaces.Resize(0);
  for (const Entry& entry : this->NearTriangles)
  {
    this->CommonFaces.AddCandidate(
      PositionsOf(this->OriginalMesh, entry.Id), target.Limit(entry.Id));
  }
  constexpr double any = std::numeric_limits<double>::infinity();
  CommonFaceProof::Piece whole;
  std::transform(piece.Corners.begin(), piece.Corners.end(), whole.begin(),
    [this](const Vector3& p) {
      return CommonFaceProof::Corner{ p, any, this->CommonFaces.FacesNear(p, any) };
    });
  CommonFaceProof::Faces used = 0;
  return this->CommonFaces.Prove(whole, used, MaxPartsOfPiece);
}

//------------------------------------------------------------------------------
/// Collects the original triangles that are connected to the seed and may be within their limit of
/// the piece. False if there are too many.
bool FaceProof::GatherNear(const WalkedSurface& target, const Piece& piece, Index seed)
{
  const Vector3 middle = (piece.Corners[0] + piece.Corners[1] + piece.Corners[2]) / 3.0;
  double radius = 0.0; // mm, of the piece
  for (const Vector3& corner : piece.Corners)
  {
    radius = std::max(radius, (corner - middle).norm());
  }
  this->NearTriangles.Clear();
  this->NearTriangles.Insert({ seed });
  for (Index at = 0; at < this->NearTriangles.Size(); ++at)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      const HalfEdgeId twin =
        this->OriginalMesh.Twin(HalfEdgeMesh::HalfEdge(this->NearTriangles[at].Id, corner));
      const FaceId face = twin == None ? FaceId() : HalfEdgeMesh::Face(twin);
      if (face != None && this->NearTriangles.Find(face) == None &&
        this->BoxReaches(face, middle, target.Limit(face) + radius))
      {
        this->NearTriangles.Insert({ face });
      }
    }
    if (this->NearTriangles.Size() > MaxNearTriangles)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Whether the box of an original triangle is within a distance (mm) of p.
bool FaceProof::BoxReaches(FaceId face, const Vector3& p, double distance) const
{
  const Triangle v = this->OriginalMesh.Corners(face);
  const Vector3& a = this->OriginalMesh.Position(v[0]);
  const Vector3& b = this->OriginalMesh.Position(v[1]);
  const Vector3& c = this->OriginalMesh.Position(v[2]);
  const Vector3 below = a.cwiseMin(b).cwiseMin(c) - p;
  const Vector3 above = p - a.cwiseMax(b).cwiseMax(c);
  return below.cwiseMax(above).cwiseMax(0.0).squaredNorm() <= distance * distance;
}

//------------------------------------------------------------------------------
void FaceProof::Halve(const Piece& piece, Index hint)
{
  std::size_t edge = 0;
  double longest = -1.0; // mm^2
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double length = (piece.Corners[(i + 1) % 3] - piece.Corners[i]).squaredNorm();
    if (length > longest)
    {
      longest = length;
      edge = i;
    }
  }
  const std::size_t next = (edge + 1) % 3;
  Piece half = { piece.Corners, hint, piece.Halvings + 1 };
  const Vector3 middle = 0.5 * (piece.Corners[edge] + piece.Corners[next]);
  half.Corners[next] = middle;
  this->OpenPieces.push_back(half);
  half.Corners[next] = piece.Corners[next];
  half.Corners[edge] = middle;
  this->OpenPieces.push_back(half);
}
}
