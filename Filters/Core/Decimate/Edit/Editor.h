// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The single mutation point: every change of the mesh is made here.
 *
 *     Collapse:           rules (CollapseRules.h)  ->  filters  ->  mesh  ->  filters commit
 *                         ->  areas, quadrics, origins, counts, hook             (CollapseEdit.cxx)
 *     CollapseTogether:   the same for one edge of a feature curve in all patches there
 *       (EditTogether.cxx)
 *     CollapseAndMove:    a collapse, moves and flips near it as one edit     (CollapseAndMove.cxx)
 *     Flip, Move:         rules (FlipAndMoveRules.h)  ->  filters  ->  mesh  ->  filters commit
 *                         ->  hook                                     (FlipEdit.cxx, MoveEdit.cxx)
 *     Split:          the same with SplitRules.h; the new vertex and faces take ids of removed ones
 *                         ->  areas, origins, counts, hook                          (SplitEdit.cxx)
 *
 * Filters (EditFilter.h): AddFilters has their order, EditorSettings.h says which of them there
 * are.
 *
 * The rules of a kind of edit are the same in every mode; EditorSettings.h says which bookkeeping
 * is done. Flips and moves remove nothing: they have rules of their own and leave areas, quadrics,
 * origins and counts as they are. Workers with a workspace each may apply edits at the same time as
 * long as their neighborhoods have no vertex in common, or check edits at the same time that one of
 * them applies afterwards. Settle adds their counts to those of the editor, in an order that does
 * not depend on the threads.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_Editor_h
#define BoneDecimate_Core_Decimate_Edit_Editor_h

#include "Base/Monitor.h"
#include "EditWorkspace.h"
#include "EditorSettings.h"
#include "Figures/EditFigures.h"
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
#include "RingQuadrics.h"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace bonedecimate
{
class BulkProof;
class IntersectionGuard;
struct Draft;

class Editor
{
public:
  /// @param clean Must live as long as this.
  Editor(const CleanSurface& clean, const EditorSettings& settings);
  /// @param mesh Made of the surface.
  /// @param monitor If it requests a stop, error bound, guards, constraints and
  /// feature curves are not set up, and no edit may follow.
  Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const EditorSettings& settings,
    const Monitor& monitor = {});
  Editor(CleanSurface&&, const EditorSettings&) = delete;
  ~Editor();

  /// What the result is to be like: the mesh before the first edit, smoothed, or the reference;
  /// only with KeepsInitialMesh or an error bound.
  const HalfEdgeMesh& InitialMesh() const
  {
    return this->Continued != nullptr ? this->Continued->Mesh : *this->First;
  }
  /// The mesh that the error bound refers to: the one before the first edit, not smoothed, or the
  /// reference; only with an error bound.
  const HalfEdgeMesh& BoundedMesh() const
  {
    return this->Unsmoothed ? *this->Unsmoothed : this->InitialMesh();
  }
  /// Bounding tree of BoundedMesh().
  const BoundingTree& BoundedTree(int threads = 1) const
  {
    return this->Continued != nullptr ? this->Continued->Tree : this->Source.Tree(threads);
  }
  /// For each vertex of InitialMesh(), the vertex into which it was merged, or one near it.
  std::vector<Index> CurrentVertices() const;
  /// For each vertex of the mesh, a triangle of InitialMesh() near it; null if both have the same
  /// vertices.
  const std::vector<Index>* NearInitial() const
  {
    return this->Continued != nullptr ? &this->Continued->NearTriangle : nullptr;
  }
  /// How many vertices are constrained because of their own tolerance; duplicates count once.
  Index NumberOfConstrainedVertices() const { return this->ConstrainedVertices; }
  bool HasErrorBound() const { return this->Bound != nullptr; }
  /// Whether an error bound or the voxels end the run, so that the final number of triangles is not
  /// known in advance.
  bool LimitsEdits() const { return this->HasErrorBound() || this->GuardsVoxels; }
  /// Whether a collapse was rejected because it could not be proved to keep the error bound.
  bool MetItsLimit() const
  {
    return this->RejectionCounts[static_cast<std::size_t>(Rejection::ErrorBound)] > 0;
  }

  /// Gathers what lies around the edge and checks the rules of a collapse that do not depend on the
  /// position.
  Decision Validate(HalfEdgeId edge);
  Decision Validate(HalfEdgeId edge, Workspace& work) const;

  /// What Validate gathered last; valid until the next edit is applied.
  const EdgeNeighborhood& Around() const { return this->Own.Around; }

  /// Applies the collapse of the edge that was validated last if rules and filters accept it.
  /// Otherwise nothing changes; rejections are counted.
  Decision Collapse(const Edit& edit);
  Decision Collapse(const Edit& edit, Workspace& work, int workers);

  /// The two halves of Collapse: rules and filters, which change nothing but the workspace, and
  /// then the change. Several edits may be checked at the same time if no vertex is an end of two
  /// of them, and applied one after the other: an accepted one if no face within Reach has changed
  /// since, and StillAccepts.
  Decision CheckCollapse(const Edit& edit, Workspace& work, int workers) const;
  void ApplyCollapse(Workspace& work);
  /// mm, around the faces that the edit checked last changes.
  double Reach(const Workspace& work) const;
  bool StillAccepts(Workspace& work) const;

  /// Collapses one edge of a feature curve in all manifold patches at it, onto the end that does
  /// not move: all or none. No other worker may be active.
  Decision CollapseTogether(const std::vector<Edit>& edits);

  /// Collapses an inside edge, moves vertices and flips edges near it, as one edit: all or nothing.
  /// The states between, which may exceed the error bound, are never left in the mesh, and no level
  /// of the log ends in them. No other worker may be active; counts are settled. Quadrics are not
  /// updated.
  Decision CollapseAndMove(const Edit& edit, const NearbyEdits& nearby, Workspace& work);

  /// Replaces the edge by the other diagonal of its two faces if rules and filters accept it.
  /// Neither flips nor their rejections are counted.
  Decision Flip(HalfEdgeId edge, Workspace& work, int workers);

  /// Moves a vertex if rules and filters accept it; not counted either.
  /// @param position mm from the local origin.
  Decision Move(VertexId vertex, const Vector3& position, Workspace& work, int workers);

  /// Edges may be split from now on; a later call makes ids of vertices and faces usable that were
  /// removed since. False where the run is recorded: levels of a log have no more triangles than
  /// the level before.
  bool BeginSplits();
  /// Puts a vertex on the edge if rules and filters accept it; not counted as a collapse.
  /// Rejection::Shape if no id of a removed vertex is left: no result has more triangles than the
  /// input. No other worker may be active.
  /// @param position mm from the local origin
  Decision Split(HalfEdgeId edge, const Vector3& position, Workspace& work);
  std::int64_t NumberOfSplits() const { return this->NumberOfSplitEdges; }

  /// Collapses that follow are a draft until EndDraft or UndoDraft (Draft.h). False, and nothing
  /// changes, if there can be none or there was one: an editor drafts once.
  bool BeginDraft(int threads);
  /// Proves the draft and undoes what is not proved. False if the monitor requested a stop; then
  /// all of it is undone.
  bool EndDraft(int threads, const Monitor& monitor);
  /// Undoes all of it.
  void UndoDraft(int threads);
  const DraftFigures& DraftReport() const { return this->DraftFound; }

  /// Feature curves between manifold patches; null if the settings do not allow their collapse.
  PatchBoundaries* FeatureCurves();

  /// mm, the largest distance that the result may have from this vertex of the input; infinite
  /// without an error bound.
  double LimitAt(VertexId vertex) const
  {
    return this->Bound ? this->Bound->LimitAt(vertex) : std::numeric_limits<double>::infinity();
  }

  /// LimitAt() of all vertices of BoundedMesh().
  std::vector<float> Limits() const;

  /// Adds the counters of a worker to those of the editor and resets them.
  void Settle(Tally& tally);
  /// Adds the counters of workers that were active at the same time, in their order.
  void Settle(std::vector<Tally>& tallies);

  /// Takes the log, once, after the last edit and only if edits are recorded. Positions are in mm
  /// from the local origin.
  EditLog TakeLog() { return this->Recorder->Take(); }
  /// To be called before and after flips and moves, for the log.
  void BeginFlipsAndMoves();
  void EndFlipsAndMoves();

  /// Measures the volumes of the fragments and distributes among blocks the volume that each may
  /// still lose. To be called before a pass of flips or moves, and after the last one.
  void DistributeVolumeBudget() { this->Fragments->DistributeBudget(this->Half); }

  /// Recomputes the quadrics of all vertex records. Needed after flips and moves, which do not
  /// update them.
  void RenewQuadrics(int threads) { SumRingQuadrics(this->Half, threads); }

  /// Called after every applied edit, and once for each patch by CollapseTogether; for invariant
  /// checks and logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->AfterEdit = std::move(hook); }
  /// While a hook is set, only one worker may be active.
  bool HasHook() const { return static_cast<bool>(this->AfterEdit); }

  const HalfEdgeMesh& Mesh() const { return this->Half; }
  const FaceAreas& Areas() const { return *this->FaceGeometry; }
  const Original& Reference() const { return this->Source; }
  Index NumberOfFragments() const { return this->Fragments->Count(); }
  /// Which vertices they have, and what they lost up to the last DistributeVolumeBudget.
  const FragmentGuard& Components() const { return *this->Fragments; }
  std::int64_t NumberOfCollapses() const { return this->Edits; }
  const std::array<std::int64_t, NumberOfRejections>& Rejections() const
  {
    return this->RejectionCounts;
  }

private:
  void AddFilters(const EditorSettings& settings, const Monitor& monitor);
  void TakeSmoothedPositions(const std::vector<Vector3>& positions);
  void AddErrorBound(const EditorSettings& settings);
  void AddRecorder();
  void AddIntersectionGuard(const EditorSettings& settings, const Monitor& monitor);
  Index ConstrainVertices(const std::vector<double>& tolerances, const std::vector<char>& others);
  std::vector<char> NearUnproved(std::vector<char> constrained) const;
  Vector3 Rounded(const Vector3& position) const;
  ProposedEdit& Propose(
    const Edit& edit, VertexId vertex, double volumeChange, Workspace& work, int workers) const;
  Decision RunFilters(Workspace& work) const;
  void Commit(Workspace& work);
  void KeepFirstNormal(FaceId face);
  void SettleAll(Tally* tallies, std::size_t count);
  Decision CheckEdge(HalfEdgeId edge, Workspace& work) const;
  void ChangeMesh(const Edit& edit, Workspace& work);
  void UpdateBookkeeping(const Edit& edit, VertexId gone, Workspace& work);
  bool ChooseSlots(Edit& edit);
  void ApplySplit(const Edit& edit, Workspace& work);
  void ApplyTogether(const Edit& edit, const NearbyEdits& nearby, const Workspace& work);
  Decision TryFlips(
    const std::vector<EdgeFlip>& flips, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved);
  void SaveOnce(FaceId face, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved) const;
  Decision FillTogether(const Edit& edit, const NearbyEdits& nearby, Workspace& work);
  void CommitTogether(const Edit& edit, const NearbyEdits& nearby, Workspace& work);
  /// Data of one of the patches of CollapseTogether.
  struct PatchEdit
  {
    Workspace Space;
    Vector3 Origin;      // of its fan, mm
    double VolumeChange; // mm^3
  };
  void ForgetPending();
  std::vector<Index> FindRejectedEdits(BulkProof& proof, int threads);
  std::vector<std::vector<Index>> FindEnclosing(const BoundingTree* tree, int threads) const;
  std::vector<char> FindWrongComponents(int threads) const;
  ErrorLimits LimitsOfDraft(bool isFirst, int threads) const;
  void Undo(const std::vector<Index>& edits);
  void UndoWithDependents(Index edit);
  void UndoOne(Index edit);
  void FinishDraft(int threads);
  Rejection CheckTogether(const std::vector<Edit>& edits);
  Decision FilterTogether(const std::vector<Edit>& edits);

  HalfEdgeMesh Half;
  std::unique_ptr<const HalfEdgeMesh> First;
  std::unique_ptr<const HalfEdgeMesh> Unsmoothed; // for the error bound; null: First
  const ReferenceMesh* Continued;                 // null: the mesh is the original
  std::vector<Index> Unproved;                    // triangles of the reference
  std::optional<FaceAreas> FaceGeometry;
  bool KeepsQuadrics;
  Original Source;
  std::shared_ptr<FragmentGuard> Fragments;
  std::shared_ptr<ErrorBound> Bound;
  std::shared_ptr<IntersectionGuard> Guard;
  bool GuardsVoxels = false;
  bool KnowsAround; // whether the original is known within two errors of what is edited
  std::shared_ptr<EditRecorder> Recorder;
  std::vector<std::shared_ptr<EditFilter>> Filters; // in order
  bool NeedsSurfaceChange = false;                  // whether any filter does
  Workspace Own;
  std::vector<PatchEdit> ManifoldPatches; // of CollapseTogether, kept for their memory
  std::unique_ptr<PatchBoundaries> Curves;
  std::unique_ptr<Draft> Drafted; // while there is one
  DraftFigures DraftFound;
  std::optional<FreeSlots> VertexSlots; // of splits
  std::optional<FreeSlots> FaceSlots;
  Hook AfterEdit;
  Index ConstrainedVertices = 0;
  std::int64_t Edits = 0;
  std::int64_t NumberOfSplitEdges = 0;
  std::array<std::int64_t, NumberOfRejections> RejectionCounts{};
};
}

#endif
