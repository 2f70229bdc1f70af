// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Relaxation.h
 * @brief Fits what is left after the collapse to samples of the original, by edge flips and moves of vertices.
 *
 *     Begin:       distribute the samples over the faces
 *     Sweep:       let the samples settle  ->  flip edges  ->  move vertices
 *     CollapseTo:  let the samples settle  ->  the last collapses by the sampled error itself
 *
 * Sweeps leave the number of triangles, the topology, open borders and locked parts as they are.
 */
#ifndef BoneDecimate_Core_Relax_Relaxation_h
#define BoneDecimate_Core_Relax_Relaxation_h

#include "Collapse/Editor.h"
#include "Reference/BackHints.h"
#include "Reference/Samples.h"

namespace bonedecimate
{
class Relaxation
{
public:
  /// @param original The mesh before the first collapse, which must stay.
  Relaxation(Editor& editor, const HalfEdgeMesh& original, int threads);

  /// All monitors hear fractions from 0 to 1. False if one said stop; the surface is valid then, too.
  bool Begin(const Monitor& monitor);
  bool Sweep(int times, const Monitor& monitor);
  /// @param edgesOfCollapse How many edges are judged for each collapse that is wanted.
  bool CollapseTo(Index faces, int edgesOfCollapse, const Monitor& monitor);

private:
  bool Settle(const Monitor& monitor);
  bool FlipEdges(const Monitor& monitor);
  bool MoveVertices(const Monitor& monitor);
  int EditThreads() const { return this->Work.HasHook() ? 1 : this->Threads; }

  Editor& Work;
  Samples Fit;
  BackHints Back;
  int Threads;
  bool IsSettled = false; // whether no vertex has moved since the samples were
};
}

#endif
