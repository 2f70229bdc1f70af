// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Editor.h
 * @brief The one choke point through which every change of the mesh goes.
 *
 *     Apply(edit):  gate (ends, topology, place, fragment)  ->  mesh  ->  bookkeeping (areas, origins, volumes, hook)
 *
 * The gate before and the bookkeeping after are the same for every mode and every kind of edit.
 */
#ifndef BoneDecimate_Core_Collapse_Editor_h
#define BoneDecimate_Core_Collapse_Editor_h

#include "Fragments.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Neighbourhood.h"
#include "Reference/Original.h"
#include "Report.h"

#include <array>
#include <functional>

namespace bonedecimate
{
class Editor
{
public:
  /// @param recordDistances Look up every new vertex on the original: needed for an error to stop
  /// at, and not free.
  Editor(const CleanSurface& clean, bool recordDistances);

  /// Gathers what lies around the edge and judges what does not depend on the place.
  Verdict Examine(Index edge);

  /// What Examine gathered last; valid until the next edit is applied.
  const Neighbourhood& Around() const { return this->Examined; }

  /// Judges the edit and, if it is allowed, carries it out. Refused edits change nothing and are counted.
  Verdict Apply(const Edit& edit);

  /// Before a pass of ApplySmall: shares what the fragments may lose.
  void ShareVolumes() { this->Volumes.Share(this->Half); }

  /**
   * Judges a flip or a move and, if it is allowed, carries it out. Threads may do so at the same time as long as none edits
   * what another one's vertices are joined to, and no hook is set. Refusals are not counted.
   */
  Verdict ApplySmall(const Edit& edit);

  /// After moves: looks all moved vertices up on the original, if distances are recorded.
  void LookUpVertices();

  bool HasHook() const { return static_cast<bool>(this->AfterEdit); }

  /// Called after every applied edit, for invariant checks and logs.
  using Hook = std::function<void(const Editor&, const Edit&)>;
  void SetHook(Hook hook) { this->AfterEdit = std::move(hook); }

  const HalfEdgeMesh& Mesh() const { return this->Half; }
  const FaceAreas& Areas() const { return this->FaceGeometry; }
  const Original& Reference() const { return this->Source; }
  Original& Reference() { return this->Source; }
  std::int64_t NumberOfEdits() const { return this->Edits; }
  const std::array<std::int64_t, NumberOfVerdicts>& Refusals() const
  {
    return this->RefusalsByVerdict;
  }

private:
  Verdict JudgeEdge(Index edge);
  Verdict ApplyFlip(Index edge);
  Verdict ApplyMove(Index vertex, const Vector3& position);
  Verdict Count(Verdict verdict);
  void KeepBooks(const Edit& edit, Index gone, double volumeChange);

  HalfEdgeMesh Half;
  FaceAreas FaceGeometry;
  Original Source;
  Fragments Volumes;
  NeighbourhoodGatherer Gatherer;
  Neighbourhood Examined;
  Hook AfterEdit;
  std::int64_t Edits = 0;
  std::array<std::int64_t, NumberOfVerdicts> RefusalsByVerdict{};
};
}

#endif
