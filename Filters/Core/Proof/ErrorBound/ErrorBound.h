// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorBound.h
 * @brief No point of the original is farther than a limit from the result, and none of the result
 * from the original. The limit may differ from vertex to vertex: ErrorLimits.h.
 *
 *     Prove(edit):   the new vertex lies within the limit of the original
 *                    every original that a changed face proved is proved again by the new faces
 *                      (CommonFaceProof)
 *                    every new face is proved by the original                           (FaceProof)
 *                    the same for boundaries, curve to curve
 *     Commit(edit):  which face covers which original
 *
 * All proofs are against the original itself, so that no error adds up. A search that misses a
 * candidate rejects the edit.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_ErrorBound_h
#define BoneDecimate_Core_Proof_ErrorBound_ErrorBound_h

#include "Base/WorkspacePool.h"
#include "BoundaryCurves.h"
#include "Coverage.h"
#include "ErrorLimits.h"
#include "Geometry/Zone.h"
#include "Mesh/CutEdges.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/PointRounding.h"
#include "Proof/EditFilters/EditFilter.h"
#include "Proof/Reference/Original.h"
#include "Proof/Reference/ReferenceMesh.h"

#include <array>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace bonedecimate
{
class BulkProof;
class DraftFilter;
class Prover;

/// The error that every edit keeps.
struct ErrorBoundSettings
{
  /// mm, the limit everywhere
  double Error = std::numeric_limits<double>::infinity();
  PointRounding Rounding = {};      ///< Rounding of written points.
  Vector3 Origin = Vector3::Zero(); ///< mm, the position that points are rounded relative to.
  /// mm, of each vertex of the mesh at first; negative or not a number: none of its own. Null:
  /// Error everywhere. Read only when the guarantee is made.
  const std::vector<double>* Tolerances = nullptr;
  CutEdges Cuts = {}; ///< Cut edges of a run that continues an earlier one, before the first edit.

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const;
};

class ErrorBound : public EditFilter
{
public:
  /// @param atFirst The mesh before the first edit. It must not change and, like the tree of its
  /// triangles, must outlive this object.
  ErrorBound(
    const HalfEdgeMesh& atFirst, const BoundingTree& tree, const ErrorBoundSettings& settings);
  /// For a run that continues an earlier one: nothing is covered before ProveStart (StartProof.h).
  /// @param reference Must outlive this object.
  /// @param mesh Before the first edit. Settings must have no tolerances.
  ErrorBound(
    const ReferenceMesh& reference, const HalfEdgeMesh& mesh, const ErrorBoundSettings& settings);
  ~ErrorBound() override;

  std::shared_ptr<Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  Decision Check(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending) const override;
  /// Whether the coverage of all items is that of the proof.
  bool StillAccepts(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending) const override;
  void Adopt(VertexId made, VertexId like) override;
  void Commit(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending, Tally& tally) override;

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const { return this->Settings.Rounded(position); }

  /// mm, how far the result may be from an original vertex, without slack: never above
  /// ErrorBoundSettings::Error, infinite where nothing limits, 0 where nothing may change.
  double LimitAt(VertexId vertex) const { return this->Allowed.At(vertex); }
  /// LimitAt() of all vertices.
  std::vector<float> LimitsOfVertices() const;
  const ErrorLimits& Limits() const { return this->Allowed; }

  /// Covers the boundaries of the original by those of the mesh, as ProveStart.
  /// @return Triangles of edges that are not proved.
  std::vector<Index> CoverBoundaries(const HalfEdgeMesh& mesh, const Zone* zone);

private:
  friend class BulkProof;
  friend class DraftFilter;
  friend class Prover;

  void BuildCoverage();
  /// Lends a prover to one worker; its memory is proportional to the mesh.
  std::shared_ptr<Prover> BorrowProver() const;

  const HalfEdgeMesh& Source;
  const BoundingTree& Tree;
  const CutEdges CutsOfSource;
  ErrorBoundSettings Settings;
  ErrorLimits Allowed; // a little less than the error: for the rounding of the proof itself
  /// Like ByBoundaries and Witnesses, empty before the first edit is proved by itself: a draft
  /// needs the memory. Until then each original is covered by the face that it was.
  Coverage ByFaces;
  std::mutex Building;                // held while the coverages are built
  BoundaryCurves Boundaries;          // of the original: the items of ByBoundaries
  Coverage ByBoundaries;              // covered by half-edges
  std::vector<Index> NearestBoundary; // of each vertex: an original boundary edge near it
  std::vector<Index> Nearest;         // of each vertex of the mesh: an original triangle near it
  /// Originals that could not be proved, the last one first.
  using Witness = std::array<Index, 4>;
  // of each vertex; checks write those of the ends of their edit
  mutable std::vector<Witness> Witnesses;
  mutable WorkspacePool<Prover> Provers;
};
}

#endif
