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
 * Workers check in one of two ways. Either several workers call Screen, Check and Commit at the
 * same time, each with its own Pending and on its own part of the mesh; a filter that would have to
 * read another part defers the edit. Or several edits are checked at the same time, each with its
 * own Pending and the whole mesh as its part, and committed one after the other
 * (Decimate/Schedule/BatchSweep.h).
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
  /// State of a filter for one worker: what it knows of the edit checked last, for Commit, and
  /// working memory.
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

  /// Decides what it can at little cost.
  /// @param mesh Before the edit.
  virtual Decision Screen(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return Decision::Accept();
  }

  /// Decides what Screen left open.
  /// @param mesh Before the edit.
  virtual Decision Check(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return Decision::Accept();
  }

  /// mm, after Check: what lies farther away from the faces that the edit changes had no influence
  /// on the decision.
  virtual double Reach(const Pending& /*pending*/) const { return 0.0; }

  /// Whether the edit checked last is still accepted after others were committed that changed no
  /// face within Reach.
  virtual bool StillAccepts(
    const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/, Pending& /*pending*/) const
  {
    return true;
  }

  /// Copies what is known of a vertex to the one that a split will make, before the split is
  /// proposed. The id may be that of a removed vertex. No other worker is active.
  virtual void Adopt(VertexId /*made*/, VertexId /*like*/) {}

  /// Records the edit that all filters accepted.
  /// @param mesh The mesh after the edit.  @param tally Counters of the worker.
  virtual void Commit(const HalfEdgeMesh& /*mesh*/, const SurfaceChange& /*change*/,
    Pending& /*pending*/, Tally& /*tally*/)
  {
  }

  /// Adds its part of the tallies to its own state, in an order that does not depend on the
  /// threads. No worker is active.
  virtual void Settle(Tally* /*tallies*/, std::size_t /*count*/) {}
};
}

#endif
