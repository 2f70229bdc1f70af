// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Relaxation.h
 * @brief After the collapse: fits what is left to samples of the original, by edge flips and moves of vertices.
 *
 *     distribute the samples over the faces
 *     sweep:  flip edges  ->  move vertices  ->  let the samples settle
 *
 * The number of triangles, the topology, open borders and locked parts stay as they are.
 */
#ifndef BoneDecimate_Core_Relax_Relaxation_h
#define BoneDecimate_Core_Relax_Relaxation_h

#include "Collapse/Editor.h"
#include "Reference/BackHints.h"
#include "Reference/Samples.h"
#include "VertexBlocks.h"

namespace bonedecimate
{
class Relaxation
{
public:
  /// @param original The mesh before the first collapse, which must stay.
  Relaxation(Editor& editor, const HalfEdgeMesh& original, int threads);

  /// @param monitor Hears fractions from 0 to 1. Returns false if it said stop; the surface is valid then, too.
  bool Run(int sweeps, const Monitor& monitor);

private:
  bool Begin(const Monitor& monitor);
  bool FlipEdges(const Monitor& monitor);
  bool MoveVertices(const Monitor& monitor);
  int EditThreads() const { return this->Work.HasHook() ? 1 : this->Threads; }

  Editor& Work;
  Samples Fit;
  BackHints Back;
  int Threads;
};
}

#endif
