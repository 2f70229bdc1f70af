// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The single mutation point: every change of the mesh is checked, applied and undone here.
 *
 *     Check:      rules of the kind of edit, which fill the change    (EditorCheck.cxx, ...Rules.h)
 *                 filters in the order of AddFilters                  (EditFilter.h)
 *     Apply:      mesh, commit of the filters, areas, quadrics,
 *                 origins, counts, hook                               (EditorApply.cxx)
 *     Try:        Check, and Apply if accepted. Several edits are one
 *                 change: all of them are made or none                (EditTogether.cxx)
 *     MakeDraft:  collapses that are proved together; what fails is
 *                 undone                                              (Draft.h)
 *
 * EditorSettings.h says which filters run and which data are maintained. The rules of a kind of
 * edit are the same in every mode. Flips and moves leave areas, quadrics, origins and counts as
 * they are.
 *
 * Workers with a workspace each may apply edits at the same time if their neighborhoods have no
 * vertex in common. Or they may check edits at the same time, and one of them applies these edits
 * afterwards. Settle adds their counts to those of the editor, in an order that does not depend on
 * the threads.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_Editor_h
#define BoneDecimate_Core_Decimate_Edit_Editor_h

#include "Base/Monitor.h"
#include "EditTotals.h"
#include "EditWorkspace.h"
#include "EditorSettings.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/FreeSlots.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/PatchBoundaries.h"
#include "Proof/EditFilters/EditRecorder.h"
#include "Proof/EditFilters/FragmentGuard.h"
#include "Proof/ErrorBound/ErrorBound.h"
#include "Proof/Reference/Original.h"

#include <functional>
#include <memory>
#include <optional>

namespace bonedecimate
{
class EditJournal;
class IntersectionGuard;

class Editor
{
public:
  /// @param clean Must outlive this.
  Editor(const CleanSurface& clean, const EditorSettings& settings);
  /// @param mesh The mesh of the surface.
  /// @param monitor If it requests a stop, error bound, guards, constraints and feature curves are
  /// not set up, and no edit may follow.
  Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const EditorSettings& settings,
    const Monitor& monitor = {});
  Editor(CleanSurface&&, const EditorSettings&) = delete;
  ~Editor();

  /// Gathers the neighborhood of the edge and checks the rules of a collapse that do not depend on
  /// the position.
  Decision Gather(HalfEdgeId edge, EditWorkspace& workspace) const;

  /// Checks rules and filters. Only the workspace changes, and rejections of collapses are counted
  /// in it. Several edits may be checked at the same time if no vertex is an end of two of them.
  /// They are applied one after the other. An accepted edit may still be applied if no face within
  /// its Reach has changed since and StillAccepts agrees.
  /// @param edit Not a split. A collapse is gathered here unless it was gathered before.
  Decision Check(const Edit& edit, EditWorkspace& workspace) const;
  bool StillAccepts(EditWorkspace& workspace) const;
  /// Applies the change that was checked and accepted last.
  void Apply(EditWorkspace& workspace);

  /// Checks the edit and applies it if it is accepted; otherwise nothing changes. A split puts a
  /// vertex on the edge; it is rejected with Rejection::Shape if no id of a removed vertex is left,
  /// because no result has more triangles than the input. No other worker may be active during a
  /// split.
  Decision Try(const Edit& edit, EditWorkspace& workspace);
  /// Collapses one edge of a feature curve in all manifold patches at it, onto the end that does
  /// not move: all or none. No other worker may be active.
  Decision Try(const std::vector<Edit>& collapses);
  /// Collapses an interior edge, moves vertices and flips edges near it as one change: all or
  /// nothing. The states between may exceed the error bound; none of them stays in the mesh, and no
  /// level of the log ends in one. No other worker may be active. Counts are settled; quadrics are
  /// not updated.
  Decision Try(const Edit& collapse, const NearbyEdits& nearby, EditWorkspace& workspace);

  /// Runs a pass of flips and moves. First measures the volumes of the fragments and distributes
  /// the volume that each may still lose among blocks. The log records the changes of the outermost
  /// pass as one. The pass is a callable, because its end may need memory, which a destructor must
  /// not request.
  /// @param workspace That of the only worker, settled at the end; null: the callable settles.
  /// @return The result of `edits`.
  bool FlipAndMove(const std::function<bool()>& edits, EditWorkspace* workspace = nullptr);
  /// Measures volumes and quadrics again. Must be called before collapses that follow flips, moves
  /// or splits, which do not update them.
  void PrepareCollapses(int threads);
  /// Allows splits. Call it again to reuse ids that were removed since. False if edits are
  /// recorded: no level of a log may have more triangles than the level before.
  bool PrepareSplits();

  /// Makes the collapses of the callable as a draft: they are not proved one by one but together at
  /// the end, and what is not proved is undone. Does nothing if there can be no draft or was one
  /// before.
  /// @return False if the callable returns false or the monitor requests a stop; then the whole
  /// draft is undone.
  bool MakeDraft(int threads, const std::function<bool()>& collapse, const Monitor& monitor);

  /// Adds the counts of workers that were active at the same time, in their order, to those of the
  /// editor, and resets them.
  void Settle(Tally* tallies, std::size_t count = 1);

  /// Called after every applied edit, once per patch at a feature curve. For invariant checks and
  /// logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->EditHook = std::move(hook); }
  /// While a hook is set, only one worker may be active.
  bool HasHook() const { return static_cast<bool>(this->EditHook); }

  const HalfEdgeMesh& Mesh() const { return this->CurrentMesh; }
  const FaceAreas& Areas() const { return *this->FaceGeometry; }
  const EditTotals& Totals() const { return this->Total; }
  /// The components of the surface: their vertices, and the volume lost up to the last measurement.
  const FragmentGuard& Components() const { return *this->Fragments; }
  /// Null: there is no error bound.
  const ErrorBound* Bound() const { return this->BoundFilter.get(); }
  /// Whether an error bound or voxels limit the edits, so that the final number of triangles is not
  /// known in advance.
  bool LimitsEdits() const { return this->BoundFilter != nullptr || this->GuardsVoxels; }
  /// Feature curves between manifold patches; null if there are none or the settings do not allow
  /// their collapse.
  PatchBoundaries* FeatureCurves();
  /// Takes the log; only once, after the last edit, and only if edits are recorded. Positions are
  /// in mm from the local origin.
  EditLog TakeLog() { return this->Recorder->Take(); }

  const bonedecimate::Original& Original() const { return this->OriginalSurface; }

private:
  friend class Draft;

  void AddFilters(const EditorSettings& settings, const Monitor& monitor);
  void AddErrorBound(const EditorSettings& settings);
  void AddRecorder();
  void AddIntersectionGuard(const EditorSettings& settings, const Monitor& monitor);
  Index ConstrainVertices(const std::vector<double>& tolerances, const std::vector<char>& others);
  std::vector<char> NearUnproved(std::vector<char> constrained) const;

  SurfaceChange& Propose(const Edit& edit, EditWorkspace& workspace) const;
  Decision CheckEdge(HalfEdgeId edge, EditWorkspace& workspace) const;
  Decision CheckCollapse(EditWorkspace& workspace) const;
  Decision CheckFlipOf(EditWorkspace& workspace) const;
  Decision CheckNewPosition(EditWorkspace& workspace) const;
  Decision RunFilters(EditWorkspace& workspace) const;
  bool PrepareSplit(Edit& edit);
  void Commit(EditWorkspace& workspace);
  void StoreInitialNormals(const std::vector<Index>& faces);
  void CollapseEdge(const Edit& edit, EditWorkspace& workspace);
  void MakeCollapse(const Edit& edit, EditWorkspace& workspace);
  void MakeSplit(const Edit& edit, EditWorkspace& workspace);
  void NoteCollapse(const Edit& edit, VertexId gone, EditWorkspace& workspace);
  void CallHook(const Edit& edit, EditWorkspace& workspace);
  void Undo(EditJournal& journal, Index edit);

  void ApplyTogether(const Edit& edit, const NearbyEdits& nearby, const EditWorkspace& workspace);
  Decision TryFlips(
    const std::vector<EdgeFlip>& flips, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved);
  void SaveOnce(FaceId face, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved) const;
  Decision FillTogether(const Edit& edit, const NearbyEdits& nearby, EditWorkspace& workspace);
  void CommitTogether(const Edit& edit, const NearbyEdits& nearby, EditWorkspace& workspace);
  Rejection CheckTogether(const std::vector<Edit>& edits);
  Decision FilterTogether(const std::vector<Edit>& edits);

  HalfEdgeMesh CurrentMesh;
  std::vector<Index> Unproved; // triangles of the reference that are not proved at the start
  std::optional<FaceAreas> FaceGeometry;
  bool KeepsQuadrics;
  bonedecimate::Original OriginalSurface;
  std::shared_ptr<FragmentGuard> Fragments;
  std::shared_ptr<ErrorBound> BoundFilter;
  std::shared_ptr<IntersectionGuard> Guard;
  bool GuardsVoxels = false;
  bool KnowsOriginalNearby; // whether all of it is known within two errors of edits
  std::shared_ptr<EditRecorder> Recorder;
  std::vector<std::shared_ptr<EditFilter>> Filters; // in order
  bool NeedsSurfaceChange = false;                  // whether any filter does
  bool IsInPass = false;                            // of flips and moves
  std::vector<EditWorkspace> PatchWorkspaces;       // at a feature curve, kept for their memory
  std::unique_ptr<PatchBoundaries> Curves;
  std::optional<FreeSlots> FreeVertexIds; // of splits
  std::optional<FreeSlots> FreeFaceIds;
  Hook EditHook;
  EditTotals Total;
};
}

#endif
