// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FragmentGuard.h
 * @brief Keeps a quarter of the volume of every closed component, so that none is flattened or
 * turned inside out.
 *
 *     collapse:       rejected if the component, with what the worker has not
 *                     settled yet, would lose too much
 *     flip, move:     allowed within the volume budget of the vertex, which needs no
 *                     bookkeeping; beyond it as a collapse
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_FragmentGuard_h
#define BoneDecimate_Core_Proof_EditFilters_FragmentGuard_h

#include "EditFilter.h"

#include <vector>

namespace bonedecimate
{
class FragmentGuard : public EditFilter
{
public:
  /// @param surface Surface of the mesh.  @param originals Original vertices, from PatchMap.
  FragmentGuard(
    const HalfEdgeMesh& mesh, const Surface& surface, const std::vector<Index>& originals = {});

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  /// Checks the edit with the volume that the other edits left.
  bool StillAccepts(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;
  void Adopt(VertexId made, VertexId like) override { this->OfVertex[made] = this->OfVertex[like]; }
  void Settle(Tally* tallies, std::size_t count) override;

  /// The number of components.
  Index Count() const { return static_cast<Index>(this->Volumes.size()); }

  Index ComponentOf(VertexId vertex) const { return this->OfVertex[vertex]; }
  bool IsClosed(Index component) const { return this->Volumes[component].IsClosed; }
  /// mm^3, the volume before the first edit less that at the last DistributeBudget, both
  /// signed; 0 unless it is closed.
  double LostVolume(Index component) const
  {
    const Volume& volume = this->Volumes[component];
    return volume.IsClosed ? volume.AtFirst - volume.Now : 0.0;
  }
  /// For each component, whether it is closed and has less than the volume that it has to keep,
  /// measured again.
  std::vector<char> FindTooSmall(const HalfEdgeMesh& mesh) const;

  /// Measures all volumes and divides what closed components may still lose among their vertices,
  /// so that vertices may be edited at the same time without the changes of other workers.
  void DistributeBudget(const HalfEdgeMesh& mesh);

private:
  struct Pending : public EditFilter::Pending
  {
    bool ExceedsBudget = false;
  };
  struct Volume
  {
    double AtFirst = 0.0; // mm^3, signed
    double Now = 0.0;
    double Budget = 0.0; // mm^3, what an edit of one vertex may take away
    bool IsClosed = true;
  };
  std::vector<double> Measure(const HalfEdgeMesh& mesh) const;
  bool MayChange(const SurfaceChange& change, int workers) const;
  bool BudgetAllows(const SurfaceChange& change) const;

  std::vector<Index> OfVertex;
  std::vector<Volume> Volumes;
};
}

#endif
