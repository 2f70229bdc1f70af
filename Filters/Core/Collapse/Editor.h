// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The one choke point through which every change of the mesh goes.
 *
 *     Apply(collapse):           Gate.h (ends, topology, place), fragment, proof  ->  mesh  ->  proof kept
 *                                ->  bookkeeping (areas, quadrics, origins, volumes, counts, hook)
 *     ApplySmall(flip or move):  SmallEdits.h, fragment, proof  ->  mesh  ->  proof kept
 *                                ->  volumes beyond the vertex's share, hook
 *
 * The proof (ProveEdits, Guard, Guarantee.h) comes last because it costs most; without a promise there is none.
 *
 * Gate and bookkeeping of a kind of edit are the same in every mode. Flips and moves remove nothing: they have rules of
 * their own and leave areas, quadrics, origins and counts as they are. Workers with a workspace each may apply edits at
 * the same time as long as their neighbourhoods have no vertex in common; Settle takes over what they counted, in an
 * order that does not depend on the threads.
 */
#ifndef BoneDecimate_Core_Collapse_Editor_h
#define BoneDecimate_Core_Collapse_Editor_h

#include "Clearance/ClearanceGuard.h"
#include "Fragments.h"
#include "Guarantee/Guarantee.h"
#include "Levels/EditRecorder.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Monitor.h"
#include "Reference/Original.h"
#include "Report.h"
#include "RingQuadrics.h"
#include "Workspace.h"

#include <array>
#include <functional>
#include <optional>

namespace bonedecimate
{
class Editor
{
public:
  /// What is kept beside the mesh, none of it for free.
  struct Books
  {
    bool Distances = true; ///< Look up every new vertex on the original: the error of mode Thesis.
    bool Areas = true;     ///< Area and normal of each face.
    bool Quadrics = false; ///< Collapse/RingQuadrics.h: the Quadric of each vertex record.
  };

  /// @param clean Must live as long as this.
  Editor(const CleanSurface& clean, const Books& books, int threads = 1);
  /// @param mesh Made of the surface.
  Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const Books& books, int threads);
  Editor(CleanSurface&&, const Books&, int = 1) = delete;

  /// A copy of the mesh as it is now, for those who measure against it; made once.
  const HalfEdgeMesh& KeepFirst();

  /// From now on every edit is proved; before the first edit.
  void ProveEdits(const Promise& promise, int threads);
  /// What has a tolerance of 0, or one too small to be proved, stays from now on, with all its faces: before the first
  /// edit and after ProveEdits.  @param tolerances Of each vertex, mm.  @return How many vertices that is.
  Index Freeze(const std::vector<double>& tolerances);
  /// From now on no proved edit may let triangles meet or narrow a gap too much.
  /// @param error mm, how far the surface may move.
  void KeepClearance(double error, int threads, const Monitor& monitor);
  bool IsGuaranteed() const { return this->Guard != nullptr; }
  /// Whether an edit was refused because nobody could prove it.
  bool MetItsLimit() const
  {
    return this->RefusalsByVerdict[static_cast<std::size_t>(Verdict::TooFar)] > 0;
  }

  /// Gathers what lies around the edge and judges what does not depend on the place.
  Verdict Examine(Index edge);
  Verdict Examine(Index edge, Workspace& work) const;

  /// What Examine gathered last; valid until the next edit is applied.
  const Neighbourhood& Around() const { return this->Own.Around; }

  /// Judges the edit and, if it is allowed, carries it out. Refused edits change nothing and are counted.
  Verdict Apply(const Edit& edit);
  Verdict Apply(const Edit& edit, Workspace& work, int workers);

  /// Takes over what a worker counted.
  void Settle(Tally& tally);
  /// Takes over what workers counted that worked side by side.
  void Settle(std::vector<Tally>& tallies);

  /// From now on the log is kept; before the first edit.
  void Record() { this->Recorder.emplace(); }
  /// Once, when all is done; positions are in mm from the local origin.
  EditLog TakeLog() { return this->Recorder->Take(); }
  /// Before and after flips and moves, for the log.
  void BeginSmallEdits();
  void EndSmallEdits();

  /// Before a pass of ApplySmall, and after the last: measures the fragments and shares what they may lose.
  void ShareVolumes() { this->Volumes.Share(this->Half); }

  /// After flips and moves, which leave the quadrics of the vertex records as they were: all of them afresh.
  void RenewQuadrics(int threads) { SumRingQuadrics(this->Half, threads); }

  /// Judges a flip or a move and, if it is allowed, carries it out. Neither they nor their refusals are counted.
  Verdict ApplySmall(const Edit& edit, Workspace& work, int workers);

  /// Called after every applied edit, for invariant checks and logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->AfterEdit = std::move(hook); }
  bool HasHook() const
  {
    return static_cast<bool>(this->AfterEdit);
  } ///< Then only one worker may work.

  const HalfEdgeMesh& Mesh() const { return this->Half; }
  const FaceAreas& Areas() const { return *this->FaceGeometry; }
  const Original& Reference() const { return this->Source; }
  Index NumberOfFragments() const { return this->Volumes.Count(); }
  std::int64_t NumberOfEdits() const { return this->Edits; }
  const std::array<std::int64_t, NumberOfVerdicts>& Refusals() const
  {
    return this->RefusalsByVerdict;
  }

private:
  void KeepFirstNormal(Index face);
  Verdict JudgeEdge(Index edge, Workspace& work) const;
  template <typename Fill>
  Verdict Prove(Workspace& work, const Fill& fill) const;
  void CommitProof(Workspace& work);
  void KeepBooks(const Edit& edit, Index gone, double volumeChange, Workspace& work);

  HalfEdgeMesh Half;
  std::unique_ptr<const HalfEdgeMesh> First;
  std::unique_ptr<Guarantee> Guard;
  std::unique_ptr<ClearanceGuard> Clearance;
  std::optional<FaceAreas> FaceGeometry;
  bool KeepsQuadrics;
  Original Source;
  Fragments Volumes;
  Workspace Own;
  Hook AfterEdit;
  std::optional<EditRecorder> Recorder;
  std::int64_t Edits = 0;
  std::array<std::int64_t, NumberOfVerdicts> RefusalsByVerdict{};
};
}

#endif
