// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FragmentGuard.h
 * @brief Keeps a quarter of the volume of every closed component, so that none is flattened or
 * turned inside out.
 *
 *     collapse:       rejected if the component, with the unsettled edits of the worker,
 *                     would lose too much
 *     flip, move:     allowed within the volume budget of the vertex without bookkeeping,
 *                     beyond it like a collapse
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
  /// Checks the edit again with the volumes after the other edits.
  bool StillAccepts(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;
  void Adopt(VertexId made, VertexId like) override
  {
    this->ComponentOfVertex[made] = this->ComponentOfVertex[like];
  }
  void Settle(Tally* tallies, std::size_t count) override;

  /// The number of components.
  Index Count() const { return static_cast<Index>(this->Volumes.size()); }

  Index ComponentOf(VertexId vertex) const { return this->ComponentOfVertex[vertex]; }
  bool IsClosed(Index component) const { return this->Volumes[component].IsClosed; }
  /// mm^3, the signed volume before the first edit minus that at the last DistributeBudget; 0
  /// unless the component is closed.
  double LostVolume(Index component) const
  {
    const Volume& volume = this->Volumes[component];
    return volume.IsClosed ? volume.Initial - volume.Current : 0.0;
  }
  /// For each component, whether it is closed and now has less than the volume that it must keep.
  std::vector<char> FindTooSmall(const HalfEdgeMesh& mesh) const;

  /// Measures all volumes, and divides what closed components may still lose among their vertices.
  /// Within this budget, vertices may be edited at the same time.
  void DistributeBudget(const HalfEdgeMesh& mesh);

private:
  struct Pending : public EditFilter::Pending
  {
    bool ExceedsBudget = false;
  };
  struct Volume
  {
    double Initial = 0.0; // mm^3, signed
    double Current = 0.0;
    double Budget = 0.0; // mm^3, that an edit of one vertex may remove
    bool IsClosed = true;
  };
  std::vector<double> Measure(const HalfEdgeMesh& mesh) const;
  bool MayChange(const SurfaceChange& change, int workers) const;
  bool BudgetAllows(const SurfaceChange& change) const;

  std::vector<Index> ComponentOfVertex;
  std::vector<Volume> Volumes;
};
}

#endif
