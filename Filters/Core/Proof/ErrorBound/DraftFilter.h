// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DraftFilter.h
 * @brief In place of ErrorBound while a draft is made: tests samples instead of proving.
 * BulkProof.h proves the result.
 *
 *     samples:   the vertices of the original and, where limits are small, the middles of its edges
 *     near:      within a fixed ratio of the limit there
 *     accepted if no vertex of a boundary or with another constraint is merged, and
 *         every sample that the old faces hold is near a new face, which holds it from then on
 *         the new vertex is near the original
 *         the centroids and the new edges' middles of the new faces are near the original
 *             (not computed while the accumulated error of the schedule is small)
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_DraftFilter_h
#define BoneDecimate_Core_Proof_ErrorBound_DraftFilter_h

#include "ErrorBound.h"
#include "Proof/EditFilters/EditFilter.h"

#include <vector>

namespace bonedecimate
{
class WalkedSurface;

class DraftFilter : public EditFilter
{
public:
  /// @param mesh A mesh within the bound.
  /// @param current For each original vertex, the vertex of the mesh into which it was merged.
  /// @param limits Limits of the original; must outlive this object.
  DraftFilter(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
    const std::vector<Index>& current, int threads);

  /// Faces that are not within the limits now stay as they are: for a mesh that is not the
  /// original.
  void KeepUnproved(const HalfEdgeMesh& mesh, int threads);

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;

private:
  struct Sample
  {
    Vector3 Position; // mm
    double Limit;     // mm
    Index Next;       // of the same face
  };
  struct Pending;
  void AddVertices();
  void AddEdges();
  void Distribute(const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads);
  bool SamplesAreNear(const SurfaceChange& change, Pending& work) const;
  bool NewFacesAreNear(const SurfaceChange& change, Pending& work) const;
  bool FacesAreProved(
    const SurfaceChange& change, const WalkedSurface& original, Index nearest) const;
  bool Keeps(const SurfaceChange& change) const;

  ErrorBound& Shared;
  const ErrorLimits& Allowed;
  std::vector<Sample> Samples;
  std::vector<Index> At;           // of each sample, an original vertex near it
  std::vector<Index> FirstOfFaces; // the first sample of each face
  std::vector<char> IsKept;        // of each face; empty: none is
};
}

#endif
