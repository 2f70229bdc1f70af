// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditFilter.h
 * @brief Decides whether an edit is applied, after the rules of its kind and before the mesh
 * changes.
 *
 *     for each filter:   Screen    cheap
 *     for each filter:   Check     costly
 *     the first decision other than accepted ends this, and nothing has changed
 *     if other edits were committed meanwhile, none of them within Reach:
 *     for each filter:   StillAccepts
 *     the editor changes the mesh
 *     for each filter:   Commit
 *     later:             Settle    commits of one worker, or of workers that worked together
 *
 * The order of the filters is part of the result: an edit is rejected for the first reason found,
 * and every Screen runs before any Check.
 *
 * Several workers call Screen, Check and Commit at the same time, each with a Pending of its own
 * and on a part of the mesh of its own. A filter that would have to read another part defers the
 * edit. Or several edits are checked at the same time, each with a Pending of its own and the whole
 * mesh as its part, and committed afterwards, one after the other: Decimate/Schedule/BatchSweep.h.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_EditFilter_h
#define BoneDecimate_Core_Proof_EditFilters_EditFilter_h

#include "Decision.h"
#include "Mesh/HalfEdgeMesh.h"
#include "SurfaceChange.h"
#include "Tally.h"

#include <memory>

namespace bonedecimate
{
class EditFilter
{
public:
  /// State of a filter for one worker: what it knows of the edit that was proposed last, for
  /// Commit, and memory to work with.
  class Pending
  {
  public:
    virtual ~Pending() = default;
  };

  virtual ~EditFilter() = default;

  /// Makes the pending data of one worker; called by several threads.
  virtual std::shared_ptr<Pending> MakePending() { return std::make_shared<Pending>(); }

  /// Whether SurfaceChange has to be filled.
  virtual bool NeedsSurfaceChange() const { return false; }

  /// What is decided at little cost.  @param mesh Before the edit.
  virtual Decision Screen(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return Decision::Accept();
  }

  /// What Screen does not decide.  @param mesh Before the edit.
  virtual Decision Check(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return Decision::Accept();
  }

  /// mm, after Check: what lies farther away from the faces that the edit changes has no influence
  /// on the decision.
  virtual double Reach(const Pending& /*pending*/) const { return 0.0; }

  /// Whether the edit that was checked last is still accepted after others were committed
  /// that changed no face within Reach.
  virtual bool StillAccepts(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return true;
  }

  /// Before a split is proposed: what is known of a vertex holds for the new one, too, whose id a
  /// removed one had. No other worker is active.
  virtual void Adopt(VertexId /*made*/, VertexId /*like*/) {}

  /// Records the edit that all filters accepted.
  /// @param mesh The mesh after the edit.  @param tally Counters of the worker.
  virtual void Commit(const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/,
    Pending& /*pending*/, Tally& /*tally*/)
  {
  }

  /// Adds its part of the tallies to its own state, in an order that does not depend on the
  /// threads; no worker is active.
  virtual void Settle(Tally* /*tallies*/, std::size_t /*count*/) {}
};
}

#endif
