// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prover.h
 * @brief Proves one edit after another for one worker: the steps of Guarantee.h.
 */
#ifndef BoneDecimate_Core_Guarantee_Prover_h
#define BoneDecimate_Core_Guarantee_Prover_h

#include "BorderProof.h"
#include "FaceProof.h"
#include "Guarantee.h"
#include "Mesh/VertexRange.h"
#include "Patch.h"
#include "PieceCover.h"
#include "ShareProof.h"
#include "SparseSet.h"

namespace bonedecimate
{
enum class ProofAnswer
{
  Proved,
  Refused,
  Elsewhere ///< What would have to be proved again is proved outside of the worker's range, too.
};

class Prover
{
public:
  explicit Prover(Guarantee& promise);

  Patch Change; ///< To be filled before Prove.

  /// @param mesh Before the edit.  @param range What may be read and written.
  ProofAnswer Prove(const HalfEdgeMesh& mesh, VertexRange range);
  /// After the edit that was proved last, before the next is asked about.
  void Commit();

private:
  using Faces = ShareProof::Faces;
  struct Item
  {
    Index Id;
    std::uint32_t Gone; // bits of its slots whose holders change
    Faces Used = 0;     // of the new faces, those that prove it
  };
  struct Point
  {
    Index Id;
    Faces Near;
    std::size_t Distances; // where they begin in SquaredDistances
  };

  static void Gather(
    const Supports& supports, const std::vector<Index>& old, SparseSet<Item>& items);
  template <typename IsInRange>
  static bool IsOurs(
    const Supports& supports, const SparseSet<Item>& items, const IsInRange& isInRange);
  bool IsOurs(const HalfEdgeMesh& mesh, VertexRange range) const;
  bool PlaceIsNear();
  void Prepare();
  bool EndsAreNear(const HalfEdgeMesh& mesh);
  bool WitnessesAreNear(const HalfEdgeMesh& mesh);
  bool Depends(Item& item) const;
  bool OriginalsAreNear(const HalfEdgeMesh& mesh);
  bool ProveItem(const HalfEdgeMesh& mesh, Item& item);
  bool ProveInPieces(const HalfEdgeMesh& mesh, Item& item);
  std::array<Index, 3> PointsOf(Index original);
  void Remember(Index item);
  std::size_t AddHelp(const HalfEdgeMesh& mesh, const Item& item);
  Index PointOf(Index id);
  Faces Nearest(const std::array<Index, 3>& points) const;
  bool NewFacesAreNear();
  bool BorderIsNear(const HalfEdgeMesh& mesh);
  bool ProveBorderItem(const HalfEdgeMesh& mesh, Item& item);
  void HandOver(Item& item);
  bool NewBorderIsNear();
  static void Commit(Supports& supports, const std::vector<Index>& gone, SparseSet<Item>& items,
    const std::vector<Index>& holders);

  Guarantee& Shared;
  SparseSet<Item> Items;
  SparseSet<Item> BorderItems;
  SparseSet<Point> Points;
  std::vector<float> SquaredDistances; // mm^2, of the points to the new faces
  ShareProof Share;
  FaceProof Back;
  PieceCover<2> BorderPieces;
  BorderProof Border;
  PieceCover<3>::Corner Place; // of the vertex that moves
  Index BorderPlace = None;    // an original border edge near the vertex that moves
  std::vector<Index> Uncut;    // items of which no new face is near all corners
  std::vector<Index> Holders;
};
}

#endif
