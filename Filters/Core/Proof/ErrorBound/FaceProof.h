// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceProof.h
 * @brief Proves that every point of a face of the result is within the error limit of some triangle
 * of the input.
 *
 *     the projected input triangles cover the face (PlaneCover):                            proved
 *     else the face, then its pieces, in the order of halving, at most 256:
 *         its middle is too far from the input:                                            rejected
 *         one input triangle is near enough to all three corners:                           proved
 *         the projected input triangles cover it:                                           proved
 *         the point that PlaneCover suspects is too far from the input:                    rejected
 *         halved at least twice, and a few triangles around it cover it (CommonFaceProof):  proved
 *         the point that is near none of these is too far from the input:                  rejected
 *         else halve its longest edge; both halves are pieces
 *
 * At boundaries and thin rims of the input, only the pieces at the rim are left to CommonFaceProof.
 * Candidates are found by walking over the input; a missed candidate can only cause a rejection.
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
    : Original(original)
    , Planes(original)
    , Around(original.NumberOfFaceSlots())
  {
  }

  /// Returns false if no proof was found.
  /// @param target The same input, with its limits.  @param hint An input triangle near the face.
  bool Prove(const WalkedSurface& target, const std::array<Vector3, 3>& face, Index hint);

private:
  struct Piece
  {
    std::array<Vector3, 3> Corners; // mm
    Index Hint;                     // an input triangle near it
    int Halvings;
  };
  struct Found
  {
    Index Id;
  };

  bool ProvePiece(const WalkedSurface& target, const Piece& piece);
  CommonFaceResult ProveTogether(const WalkedSurface& target, const Piece& piece, Index seed);
  bool GatherAround(const WalkedSurface& target, const Piece& piece, Index seed);
  bool BoxReaches(FaceId face, const Vector3& p, double distance) const;
  void Halve(const Piece& piece, Index hint);

  const HalfEdgeMesh& Original;
  PlaneCover Planes;
  CommonFaceProof CommonFaces;
  SparseSet<Found> Around;
  std::vector<Piece> Open;
};
}

#endif
