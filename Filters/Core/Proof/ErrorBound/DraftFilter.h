// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DraftFilter.h
 * @brief Replaces ErrorBound while a draft is made: tests samples, proves nothing. BulkProof.h
 * proves the result.
 *
 *     samples:   original vertices and, where limits are small, the midpoints of original edges
 *     near:      within a fixed ratio of the limit there
 *     accepted if both ends of the collapsed edge are free to move, and
 *         every sample of the old faces is near a new face, to which it then belongs
 *         the new vertex is near the original
 *         the centroids of the new faces and the midpoints of their new edges are near the original
 *             (not computed while the accumulated error of the schedule is small)
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_DraftFilter_h
#define BoneDecimate_Core_Proof_ErrorBound_DraftFilter_h

#include "Base/Monitor.h"
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

  /// Keeps all faces that are not within the limits now. For a mesh that is not the original.
  /// @return False after an abort by the monitor; then this object must not be used.
  bool KeepUnproved(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

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
    Index Next;       // in the list of its face
  };
  struct Pending;
  void AddVertices();
  void AddEdges();
  void Distribute(const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads);
  bool SamplesAreNear(const SurfaceChange& change, Pending& work) const;
  bool NewFacesAreNear(const SurfaceChange& change, Pending& work) const;
  bool FacesAreProved(
    const SurfaceChange& change, const WalkedSurface& original, Index nearest) const;
  bool HasKeptFace(const SurfaceChange& change) const;

  ErrorBound& Bound;
  const ErrorLimits& Limits;
  std::vector<Sample> Samples;
  std::vector<Index> SampleVertices; // of each sample, an original vertex near it
  std::vector<Index> FirstSamples;   // the first sample of each face
  std::vector<char> IsKept;          // of each face; empty: no face is kept
};
}

#endif
