// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceProof.h
 * @brief Proves that every point of a face of the result is within the limit of some original
 * triangle.
 *
 *     the projections of original triangles cover the face (PlaneCover):                proved
 *     else the face, then its pieces, in the order of halving, at most 256:
 *         its centroid is too far from the original:                                    rejected
 *         one original triangle is near enough to all three corners:                    proved
 *         the projections of original triangles cover it:                               proved
 *         the point that PlaneCover suspects is too far from the original:              rejected
 *         halved at least twice, and a few triangles near it cover it (CommonFaceProof): proved
 *         the point that is near none of these is too far from the original:            rejected
 *         else halve its longest edge; both halves are pieces
 *
 * At boundaries and thin rims of the original, only the pieces at the rim are left to
 * CommonFaceProof. Candidates are found by walking over the original; a missed candidate can only
 * cause a rejection.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_FaceProof_h
#define BoneDecimate_Core_Proof_ErrorBound_FaceProof_h

#include "CommonFaceProof.h"
#include "PlaneCover.h"
#include "SparseSet.h"
#include "WalkedTargets.h"

namespace bonedecimate
{
class FaceProof
{
public:
  explicit FaceProof(const HalfEdgeMesh& original)
    : OriginalMesh(original)
    , Planes(original)
    , NearTriangles(original.NumberOfFaceSlots())
  {
  }

  /// @param target The original with its limits.
  /// @param hint An original triangle near the face.
  /// @return False if no proof was found.
  bool Prove(const WalkedSurface& target, const std::array<Vector3, 3>& face, Index hint);

private:
  struct Piece
  {
    std::array<Vector3, 3> Corners; // mm
    Index Hint;                     // an original triangle near it
    int Halvings;
  };
  struct Entry
  {
    Index Id;
  };

  bool ProvePiece(const WalkedSurface& target, const Piece& piece);
  CommonFaceResult ProveTogether(const WalkedSurface& target, const Piece& piece, Index seed);
  bool GatherNear(const WalkedSurface& target, const Piece& piece, Index seed);
  bool BoxReaches(FaceId face, const Vector3& p, double distance) const;
  void Halve(const Piece& piece, Index hint);

  const HalfEdgeMesh& OriginalMesh;
  PlaneCover Planes;
  CommonFaceProof CommonFaces;
  SparseSet<Entry> NearTriangles;
  std::vector<Piece> OpenPieces;
};
}

#endif
