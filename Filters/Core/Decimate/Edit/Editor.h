// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The single mutation point: every change of the mesh is checked, applied and undone here.
 *
 *     Check:      rules of the kind of edit, which set the change    (EditorCheck.cxx, ...Rules.h)
 *                 ->  filters in the order of AddFilters                          (EditFilter.h)
 *     Apply:      mesh  ->  filters commit  ->  areas, quadrics, origins, counts, hook
 *                                                                            (EditorApply.cxx)
 *     Try:        Check, and Apply if it is accepted. Several edits at once are one change: all of
 *                 them or none                                               (EditTogether.cxx)
 *     MakeDraft:  collapses that are proved together; what fails is undone             (Draft.h)
 *
 * EditorSettings.h says which filters there are and which bookkeeping is done. The rules of a kind
 * of edit are the same in every mode. Flips and moves remove nothing: they leave areas, quadrics,
 * origins and counts as they are. Workers with a workspace each may apply edits at the same time as
 * long as their neighborhoods have no vertex in common, or check edits at the same time that one of
 * them applies afterwards. Settle adds their counts to those of the editor, in an order that does
 * not depend on the threads.
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
  /// @param clean Must live as long as this.
  Editor(const CleanSurface& clean, const EditorSettings& settings);
  /// @param mesh Made of the surface.
  /// @param monitor If it requests a stop, error bound, guards, constraints and feature curves are
  /// not set up, and no edit may follow.
  Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const EditorSettings& settings,
    const Monitor& monitor = {});
  Editor(CleanSurface&&, const EditorSettings&) = delete;
  ~Editor();

  /// Gathers what lies around the edge and checks the rules of a collapse that do not depend on the
  /// position.
  Decision Gather(HalfEdgeId edge, EditWorkspace& workspace) const;

  /// Checks rules and filters, which changes nothing but the workspace; rejections of collapses are
  /// counted. Several edits may be checked at the same time if no vertex is an end of two of them,
  /// and applied one after the other: an accepted one if no face within its Reach has changed
  /// since, and StillAccepts.
  /// @param edit Gathered before if it is a collapse, or else it is gathered now. Not a split.
  Decision Check(const Edit& edit, EditWorkspace& workspace) const;
  bool StillAccepts(EditWorkspace& workspace) const;
  /// Makes the change that was checked last and accepted.
  void Apply(EditWorkspace& workspace);

  /// Checks the edit and applies it if it is accepted; otherwise nothing changes.
  /// A split puts a vertex on the edge, not counted as a collapse; Rejection::Shape if no id of a
  /// removed vertex is left: no result has more triangles than the input. No other worker may be
  /// active then.
  Decision Try(const Edit& edit, EditWorkspace& workspace);
  /// Collapses one edge of a feature curve in all manifold patches at it, onto the end that does
  /// not move: all or none. No other worker may be active.
  Decision Try(const std::vector<Edit>& collapses);
  /// Collapses an inside edge, moves vertices and flips edges near it, as one change: all or
  /// nothing. The states between, which may exceed the error bound, are never left in the mesh, and
  /// no level of the log ends in them. No other worker may be active; counts are settled. Quadrics
  /// are not updated.
  Decision Try(const Edit& collapse, const NearbyEdits& nearby, EditWorkspace& workspace);

  /// A pass of flips and moves. Measures the volumes of the fragments first, and distributes among
  /// blocks the volume that each may still lose. The log gets the changes of the pass as one, or
  /// those of the pass around it. A scope by a callable, as that of MakeDraft: its end may need
  /// memory, which no destructor may fail to get.
  /// @param workspace If there is one worker: settled at the end.
  /// @return What `edits` does.
  bool FlipAndMove(const std::function<bool()>& edits, EditWorkspace* workspace = nullptr);
  /// Measures volumes and quadrics again for collapses that follow flips, moves and splits, which
  /// do not update them.
  void PrepareCollapses(int threads);
  /// Edges may be split from now on; a later call makes ids of vertices and faces usable that were
  /// removed since. False where the run is recorded: levels of a log have no more triangles than
  /// the level before.
  bool PrepareSplits();

  /// Collapses made by the callable are a draft: not proved one by one, but together at the end,
  /// when what is not proved is undone. Does nothing if there can be no draft or there was one.
  /// @return False if the callable does or the monitor requests a stop; then all of it is undone.
  bool MakeDraft(int threads, const std::function<bool()>& collapse, const Monitor& monitor);

  /// Adds the counters of a worker, or of workers that were active at the same time in their order,
  /// to those of the editor and resets them.
  void Settle(Tally* tallies, std::size_t count = 1);

  /// Called after every applied edit, and once for each patch at a feature curve; for invariant
  /// checks and logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->EditHook = std::move(hook); }
  /// While a hook is set, only one worker may be active.
  bool HasHook() const { return static_cast<bool>(this->EditHook); }

  const HalfEdgeMesh& Mesh() const { return this->CurrentMesh; }
  const FaceAreas& Areas() const { return *this->FaceGeometry; }
  const EditTotals& Totals() const { return this->Total; }
  /// Which vertices they have, and what they lost up to the last measurement.
  const FragmentGuard& Components() const { return *this->Fragments; }
  /// Null: there is none.
  const ErrorBound* Bound() const { return this->BoundFilter.get(); }
  /// Whether an error bound or the voxels end the run, so that the final number of triangles is not
  /// known in advance.
  bool LimitsEdits() const { return this->BoundFilter != nullptr || this->GuardsVoxels; }
  /// Feature curves between manifold patches; null if the settings do not allow their collapse.
  PatchBoundaries* FeatureCurves();
  /// Takes the log, once, after the last edit and only if edits are recorded. Positions are in mm
  /// from the local origin.
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
  std::vector<Index> Unproved; // triangles of the reference
  std::optional<FaceAreas> FaceGeometry;
  bool KeepsQuadrics;
  bonedecimate::Original OriginalSurface;
  std::shared_ptr<FragmentGuard> Fragments;
  std::shared_ptr<ErrorBound> BoundFilter;
  std::shared_ptr<IntersectionGuard> Guard;
  bool GuardsVoxels = false;
  bool KnowsOriginalNearby; // whether the original is known within two errors of what is edited
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
