// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prover.h
 * @brief Proves one edit after another for one worker: the steps of ErrorBound.h. Changes nothing
 * but the witnesses of the ends.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_Prover_h
#define BoneDecimate_Core_Proof_ErrorBound_Prover_h

#include "BoundaryProof.h"
#include "CommonFaceProof.h"
#include "ErrorBound.h"
#include "FaceProof.h"
#include "PieceCover.h"
#include "SparseSet.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// An original, or an edge of its boundaries, with covering elements that the edit changes.
struct CoveredItem
{
  Index Id;
  std::uint32_t Gone;            // bits of its slots whose covering elements change
  std::uint64_t Used = 0;        // of the new elements, those that prove it
  Coverage::Version Version = 0; // of its coverage when it was proved
};

/// What a Prover found about the edit that was checked last. It waits for its commit here, so that
/// a few provers, whose memory is in proportion to the mesh, serve many edits.
struct EditProof : public EditFilter::Pending
{
  std::vector<CoveredItem> Items;
  std::vector<CoveredItem> BoundaryItems;
  Index Nearest = None;           // an original triangle near the vertex that moves
  Index NearestBoundary = None;   // an original boundary edge near it
  std::vector<Index> NewElements; // memory of the commit
};

class Prover
{
public:
  explicit Prover(const ErrorBound& bound);

  /// Defers the edit if what would have to be proved again is proved outside of the range, too.
  /// @param mesh The mesh before the edit.
  /// @param proof Proof of an accepted edit.
  Decision Prove(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditProof& proof);

private:
  friend class BulkProof;
  friend class DraftFilter;

  using Faces = CommonFaceProof::Faces;
  using Item = CoveredItem;
  struct Point
  {
    Index Id;
    Faces Near;
    std::size_t Distances; // where they begin in SquaredDistances
  };

  static void Gather(
    const Coverage& coverage, const std::vector<Index>& old, SparseSet<Item>& items);
  template <typename IsElementInRange>
  static bool IsInRange(
    const Coverage& coverage, const Item& item, const IsElementInRange& isElementInRange);
  template <typename IsElementInRange>
  static bool AreInRange(const Coverage& coverage, const SparseSet<Item>& items,
    const IsElementInRange& isElementInRange);
  bool AreInRange(const HalfEdgeMesh& mesh) const;
  bool MovedVertexIsNear();
  void Prepare();
  bool EndsAreNear(const HalfEdgeMesh& mesh);
  bool WitnessesAreNear(const HalfEdgeMesh& mesh);
  bool Depends(Item& item) const;
  bool OriginalsAreNear(const HalfEdgeMesh& mesh);
  bool ProveItem(const HalfEdgeMesh& mesh, Item& item);
  bool ProveInPieces(const HalfEdgeMesh& mesh, Item& item);
  std::array<Index, 3> PointsOf(Index original);
  void Remember(Index item);
  std::size_t AddRemaining(const HalfEdgeMesh& mesh, const Item& item);
  Index PointOf(Index id);
  Faces Nearest(const std::array<Index, 3>& points) const;
  bool NewFacesAreNear();
  bool BoundaryIsNear(const HalfEdgeMesh& mesh);
  bool ProveBoundaryItem(const HalfEdgeMesh& mesh, Item& item);
  void HandOver(Item& item);
  bool NewBoundaryIsNear();
  static void Copy(
    const Coverage& coverage, const SparseSet<Item>& items, std::vector<Item>& copies);

  const ErrorBound& Shared;
  const SurfaceChange* Change = nullptr; // of the edit
  SparseSet<Item> Items;
  SparseSet<Item> BoundaryItems;
  SparseSet<Point> Points;
  std::vector<float> SquaredDistances; // mm^2, of the points to the new faces
  CommonFaceProof CommonFaces;
  FaceProof Back;
  PieceCover<2> BoundaryPieces;
  BoundaryProof Boundary;
  PieceCover<3>::Corner MovedCorner; // of the vertex that moves
  Index BoundaryHint = None;         // an original boundary edge near the vertex that moves
  std::vector<Index> Uncut;          // items of which no new face is near all corners
  std::vector<Index> Centroids;      // of each new face, the original triangle near its centroid
};
}

#endif
