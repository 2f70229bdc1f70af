// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The single mutation point: every change of the mesh is made here.
 *
 *     Collapse:           rules (CollapseRules.h)  ->  filters  ->  mesh  ->  filters commit
 *                         ->  areas, quadrics, origins, counts, hook                               (CollapseEdit.cxx)
 *     CollapseTogether:   the same of one edge in all manifold patches at it, as one edit          (EditTogether.cxx)
 *     Flip, Move:         rules (FlipAndMoveRules.h)  ->  filters  ->  mesh  ->  filters commit
 *                         ->  hook                                                   (FlipEdit.cxx, MoveEdit.cxx)
 *
 * Filters (EditFilter.h), in this order: fragments, error bound, voxels, intersections, those of the settings, the recorder of
 * the log. Voxels come before an error bound that allows large edits. EditorSettings.h says which of them there are.
 *
 * Rules and bookkeeping of a kind of edit are the same in every mode. Flips and moves remove nothing: they have rules of
 * their own and leave areas, quadrics, origins and counts as they are. Workers with a workspace each may apply edits at
 * the same time as long as their neighborhoods have no vertex in common; Settle takes over what they counted, in an
 * order that does not depend on the threads.
 */
#ifndef BoneDecimate_Core_Edit_Editor_h
#define BoneDecimate_Core_Edit_Editor_h

#include "EditFilters/EditRecorder.h"
#include "EditFilters/FragmentGuard.h"
#include "EditWorkspace.h"
#include "EditorSettings.h"
#include "ErrorBound/ErrorBound.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/PatchBoundaries.h"
#include "Monitor.h"
#include "Reference/Original.h"
#include "Report/Report.h"
#include "RingQuadrics.h"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace bonedecimate
{
class Editor
{
public:
  /// @param clean Must live as long as this.
  Editor(const CleanSurface& clean, const EditorSettings& settings);
  /// @param mesh Made of the surface.  @param monitor If it says stop, what the settings limit is left out, and no edit may
  /// follow.
  Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const EditorSettings& settings,
    const Monitor& monitor = {});
  Editor(CleanSurface&&, const EditorSettings&) = delete;

  /// The mesh before the first edit; only where the settings keep it.
  const HalfEdgeMesh& InitialMesh() const { return *this->First; }
  /// How many vertices are constrained because of their own tolerance; duplicates count once.
  Index NumberOfConstrainedVertices() const { return this->ConstrainedVertices; }
  bool HasErrorBound() const { return this->Bound != nullptr; }
  /// Whether an error bound or the voxels end the run, so that the final number of triangles is not known in advance.
  bool LimitsEdits() const { return this->HasErrorBound() || this->GuardsVoxels; }
  /// Whether an edit was rejected because it could not be proved to keep the error bound.
  bool MetItsLimit() const
  {
    return this->RejectionCounts[static_cast<std::size_t>(Rejection::ErrorBound)] > 0;
  }

  /// Gathers what lies around the edge and checks the rules of a collapse that do not depend on the position.
  Decision Validate(Index edge);
  Decision Validate(Index edge, Workspace& work) const;

  /// What Validate gathered last; valid until the next edit is applied.
  const EdgeNeighborhood& Around() const { return this->Own.Around; }

  /// Applies the collapse if rules and filters accept it. Otherwise nothing changes; rejections are counted.
  Decision Collapse(const Edit& edit);
  Decision Collapse(const Edit& edit, Workspace& work, int workers);

  /// The same edge in every manifold patch at it, onto one original vertex that does not move: all of them or none. No other
  /// worker may be active.
  Decision CollapseTogether(const std::vector<Edit>& edits);

  /// Replaces the edge by the other diagonal of its two faces if rules and filters accept it. Neither flips nor their
  /// rejections are counted.
  Decision Flip(Index edge, Workspace& work, int workers);

  /// The same of a move.  @param position mm from the local origin.
  Decision Move(Index vertex, const Vector3& position, Workspace& work, int workers);

  /// Null where no feature curve may be collapsed.
  PatchBoundaries* FeatureCurves();

  /// mm, how far the result may be from an original vertex; infinite without an error bound.
  double LimitAt(Index vertex) const
  {
    return this->Bound ? this->Bound->LimitAt(vertex) : std::numeric_limits<double>::infinity();
  }

  /// Takes over what a worker counted.
  void Settle(Tally& tally);
  /// Takes over what workers counted that worked side by side.
  void Settle(std::vector<Tally>& tallies);

  /// Once, after the last edit and only where edits are recorded; positions are in mm from the local origin.
  EditLog TakeLog() { return this->Recorder->Take(); }
  /// Before and after flips and moves, for the log.
  void BeginSmallEdits();
  void EndSmallEdits();

  /// Before a pass of flips or moves, and after the last: measures the fragments and divides what they may lose.
  void DistributeVolumeBudget() { this->Fragments->DistributeBudget(this->Half); }

  /// After flips and moves, which leave the quadrics of the vertex records as they were: all of them afresh.
  void RenewQuadrics(int threads) { SumRingQuadrics(this->Half, threads); }

  /// Called after every applied edit, for invariant checks and logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->AfterEdit = std::move(hook); }
  /// Then only one worker may be active.
  bool HasHook() const { return static_cast<bool>(this->AfterEdit); }

  const HalfEdgeMesh& Mesh() const { return this->Half; }
  const FaceAreas& Areas() const { return *this->FaceGeometry; }
  const Original& Reference() const { return this->Source; }
  Index NumberOfFragments() const { return this->Fragments->Count(); }
  std::int64_t NumberOfEdits() const { return this->Edits; }
  const std::array<std::int64_t, NumberOfRejections>& Rejections() const
  {
    return this->RejectionCounts;
  }

private:
  void AddFilters(const EditorSettings& settings, const Monitor& monitor);
  void AddErrorBound(const EditorSettings& settings);
  Index ConstrainVertices(const std::vector<double>& tolerances);
  Vector3 Rounded(const Vector3& position) const;
  ProposedEdit& Propose(
    const Edit& edit, Index vertex, double volumeChange, Workspace& work, int workers) const;
  Decision RunFilters(Workspace& work) const;
  void Commit(Workspace& work);
  void KeepFirstNormal(Index face);
  void SettleAll(Tally* tallies, std::size_t count);
  Decision CheckEdge(Index edge, Workspace& work) const;
  void ChangeMesh(const Edit& edit, Workspace& work);
  void UpdateBookkeeping(const Edit& edit, Index gone, Workspace& work);
  /// Of one manifold patch of several.
  struct PatchEdit
  {
    Workspace Space;
    Vector3 Origin;      // of its fan, mm
    double VolumeChange; // mm^3
  };
  Rejection CheckTogether(const std::vector<Edit>& edits);
  Decision FilterTogether(const std::vector<Edit>& edits);

  HalfEdgeMesh Half;
  std::unique_ptr<const HalfEdgeMesh> First;
  std::optional<FaceAreas> FaceGeometry;
  bool KeepsQuadrics;
  Original Source;
  std::shared_ptr<FragmentGuard> Fragments;
  std::shared_ptr<ErrorBound> Bound;
  bool GuardsVoxels = false;
  std::shared_ptr<EditRecorder> Recorder;
  std::vector<std::shared_ptr<EditFilter>> Filters; // in order
  bool NeedsSurfaceChange = false;                  // whether any filter does
  Workspace Own;
  std::vector<PatchEdit> ManifoldPatches; // of CollapseTogether; their memory stays
  std::unique_ptr<PatchBoundaries> Curves;
  Hook AfterEdit;
  Index ConstrainedVertices = 0;
  std::int64_t Edits = 0;
  std::array<std::int64_t, NumberOfRejections> RejectionCounts{};
};
}

#endif
