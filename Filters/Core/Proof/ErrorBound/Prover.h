// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prover.h
 * @brief Proves one edit after another for one worker, in the steps of ErrorBound.h. Changes
 * nothing but the witnesses of the ends.
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
/// A triangle or boundary edge of the original, of which the edit replaces covering elements.
struct CoveredElement
{
  Index Id;
  std::uint32_t ReplacedSlots;   // a bit for each slot whose covering element is replaced
  std::uint64_t ProvedBy = 0;    // a bit for each new element that proves it
  Coverage::Version Version = 0; // when it was proved
};

/// Proof of the edit that was checked last, stored until the commit. So a few provers, whose memory
/// is proportional to the mesh, serve many edits.
struct EditProof : public EditFilter::Pending
{
  std::vector<CoveredElement> CoveredTriangles;
  std::vector<CoveredElement> CoveredEdges;
  Index NearTriangle = None;      // an original triangle near the vertex that moves
  Index NearBoundaryEdge = None;  // an original boundary edge near it
  std::vector<Index> NewElements; // working memory of the commit
};

class Prover
{
public:
  explicit Prover(const ErrorBound& bound);

  /// Defers the edit if covering elements out of the range would be needed.
  /// @param mesh The mesh before the edit.
  /// @param proof Receives the proof of an accepted edit.
  Decision Prove(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditProof& proof);

private:
  friend class BulkProof;
  friend class DraftFilter;

  using Faces = CommonFaceProof::Faces;
  struct Point
  {
    Index Id;
    Faces NearCandidates;
    std::size_t FirstDistance; // position in SquaredDistances
  };

  static void Gather(
    const Coverage& coverage, const std::vector<Index>& old, SparseSet<CoveredElement>& elements);
  template <typename IsElementInRange>
  static bool IsInRange(const Coverage& coverage, const CoveredElement& covered,
    const IsElementInRange& isElementInRange);
  template <typename IsElementInRange>
  static bool AreInRange(const Coverage& coverage, const SparseSet<CoveredElement>& elements,
    const IsElementInRange& isElementInRange);
  bool AreInRange(const HalfEdgeMesh& mesh) const;
  bool MovedVertexIsNear();
  void Prepare();
  bool EndsAreNear(const HalfEdgeMesh& mesh);
  bool WitnessesAreNear(const HalfEdgeMesh& mesh);
  bool FindReplacedSlots(CoveredElement& covered) const;
  bool OriginalsAreNear(const HalfEdgeMesh& mesh);
  bool ProveTriangle(const HalfEdgeMesh& mesh, CoveredElement& covered);
  bool ProveInPieces(const HalfEdgeMesh& mesh, CoveredElement& covered);
  std::array<Index, 3> PointsOf(Index original);
  void AddWitness(Index covered);
  std::size_t AddRemaining(const HalfEdgeMesh& mesh, const CoveredElement& covered);
  Index PointOf(Index id);
  Faces NearestCommonFace(const std::array<Index, 3>& points) const;
  bool NewFacesAreNear();
  bool BoundaryIsNear(const HalfEdgeMesh& mesh);
  bool ProveBoundaryEdge(const HalfEdgeMesh& mesh, CoveredElement& covered);
  void ProveByReplacement(CoveredElement& covered);
  bool NewBoundaryIsNear();
  static void Copy(const Coverage& coverage, const SparseSet<CoveredElement>& elements,
    std::vector<CoveredElement>& copies);

  const ErrorBound& Bound;
  const SurfaceChange* Change = nullptr; // the current one
  SparseSet<CoveredElement> CoveredTriangles;
  SparseSet<CoveredElement> CoveredEdges;
  SparseSet<Point> Points;
  std::vector<float> SquaredDistances; // mm^2, from each point to all new faces
  CommonFaceProof CommonFaces;
  FaceProof NewFaceProof;
  PieceCover<2> BoundaryPieces;
  BoundaryProof Boundary;
  PieceCover<3>::Corner MovedCorner;    // the vertex that moves
  Index BoundaryHint = None;            // an original boundary edge near the vertex that moves
  std::vector<Index> UnprovedTriangles; // no new face is near all their corners
  std::vector<Index> Centroids;         // of each new face, the original triangle near its centroid
};
}

#endif
