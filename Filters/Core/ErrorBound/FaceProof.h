// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceProof.h
 * @brief Whether every point of a face lies within the limits of the original, proved.
 *
 *     the face, then its pieces, larger ones first:
 *         its middle is too far away:                                                       rejected
 *         one original is near enough to all three corners:                                 proved
 *         the projection of the original covers it (PlaneCover):                            proved
 *         the point where PlaneCover found the original too far away is too far away:       rejected
 *         small enough, and a few originals around it prove it together (CommonFaceProof):  proved
 *         else halve its longest edge; both halves are pieces
 *
 * At boundaries and thin rims of the original, only the pieces at the rim are left to CommonFaceProof. Candidates are found
 * by walking over the original; a missed candidate can only cause a rejection.
 */
#ifndef BoneDecimate_Core_ErrorBound_FaceProof_h
#define BoneDecimate_Core_ErrorBound_FaceProof_h

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

  /// @param hint An original triangle near the face.
  bool Prove(const WalkedSurface& target, const std::array<Vector3, 3>& face, Index hint);

private:
  struct Piece
  {
    std::array<Vector3, 3> Corners; // mm
    Index Hint;                     // an original triangle near it
    int Halvings;
  };
  struct Found
  {
    Index Id;
  };

  bool ProvePiece(const WalkedSurface& target, const Piece& piece);
  CommonFaceResult ProveTogether(const WalkedSurface& target, const Piece& piece, Index seed);
  bool GatherAround(const WalkedSurface& target, const Piece& piece, Index seed);
  bool BoxReaches(Index face, const Vector3& p, double distance) const;
  void Halve(const Piece& piece, Index hint);

  const HalfEdgeMesh& Original;
  PlaneCover Planes;
  CommonFaceProof CommonFaces;
  SparseSet<Found> Around;
  std::vector<Piece> Open;
};
}

#endif
