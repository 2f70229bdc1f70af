// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorBound.h
 * @brief Keeps the two-sided distance between the original and the result within a limit, which may
 * differ from vertex to vertex (ErrorLimits.h).
 *
 *     Check(edit):   the new vertex lies within the limit of the original
 *                    every original that a removed face proved is proved again by the new faces
 *                                                                              (CommonFaceProof)
 *                    every new face is proved by the original                  (FaceProof)
 *                    the same for boundaries, curve to curve                   (BoundaryProof)
 *     Commit(edit):  which face covers which original
 *
 * All proofs are against the original itself, so errors cannot accumulate. A search that misses a
 * candidate can only cause a rejection.
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

/// What every edit has to keep.
struct ErrorBoundSettings
{
  /// mm, upper limit everywhere.
  double Error = std::numeric_limits<double>::infinity();
  PointRounding Rounding = {};      ///< Rounding of written points.
  Vector3 Origin = Vector3::Zero(); ///< mm, the position that points are rounded relative to.
  /// mm, of each original vertex; negative or not a number: no limit of its own. Null: Error
  /// everywhere. Read only by constructors.
  const std::vector<double>* Tolerances = nullptr;
  CutEdges Cuts = {}; ///< Cut edges of a run that continues an earlier one, before the first edit.

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const;
};

class ErrorBound : public EditFilter
{
public:
  /// @param original The mesh before the first edit. It must not change and, like the tree of its
  ///   triangles, must outlive this object.
  ErrorBound(
    const HalfEdgeMesh& original, const BoundingTree& tree, const ErrorBoundSettings& settings);
  /// For a run that continues an earlier one. Nothing is covered before ProveStart (StartProof.h).
  /// @param reference Must outlive this object.
  /// @param mesh Before the first edit.
  /// @param settings Without tolerances.
  ErrorBound(
    const ReferenceMesh& reference, const HalfEdgeMesh& mesh, const ErrorBoundSettings& settings);
  ~ErrorBound() override;

  std::shared_ptr<Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  Decision Check(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending) const override;
  /// Whether the coverage that the proof read has not changed.
  bool StillAccepts(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending) const override;
  void Adopt(VertexId made, VertexId like) override;
  void Commit(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& pending, Tally& tally) override;

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const { return this->Settings.Rounded(position); }

  /// mm, how far the result may be from an original vertex, less the slack. At most
  /// ErrorBoundSettings::Error; infinite without a limit, 0 where nothing may change.
  double LimitAt(VertexId vertex) const { return this->OriginalLimits.At(vertex); }
  /// LimitAt() of all vertices.
  std::vector<float> LimitsOfVertices() const;
  const ErrorLimits& Limits() const { return this->OriginalLimits; }

  /// Covers the boundaries of the original by those of the mesh; a step of ProveStart.
  /// @return Triangles of the edges that are not proved.
  std::vector<Index> CoverBoundaries(const HalfEdgeMesh& mesh, const Zone* zone);

private:
  friend class BulkProof;
  friend class DraftFilter;
  friend class Prover;

  void BuildCoverage();
  /// Lends a prover to one worker; its memory is proportional to the mesh.
  std::shared_ptr<Prover> BorrowProver() const;

  const HalfEdgeMesh& OriginalMesh;
  const BoundingTree& OriginalTree;
  const CutEdges OriginalCuts;
  ErrorBoundSettings Settings;
  ErrorLimits OriginalLimits; // less than the error by the slack for rounding
  /// Empty, like BoundaryCoverage and Witnesses, until an edit is proved by itself, because a draft
  /// needs the memory. Until then each original is covered by its own face.
  Coverage FaceCoverage;
  std::mutex BuildMutex;                // of the coverages
  BoundaryCurves Boundaries;            // of the original: covered elements of BoundaryCoverage
  Coverage BoundaryCoverage;            // covered by half-edges
  std::vector<Index> NearBoundaryEdges; // of each vertex: an original boundary edge near it
  std::vector<Index> NearTriangles;     // of each vertex of the mesh: an original triangle near it
  /// Originals that caused rejections, the latest first.
  using Witness = std::array<Index, 4>;
  // of each vertex; checks write those of the ends of their edit
  mutable std::vector<Witness> Witnesses;
  mutable WorkspacePool<Prover> Provers;
};
}

#endif
