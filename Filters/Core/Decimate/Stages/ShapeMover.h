// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeMover.h
 * @brief Flips edges and moves vertices where that enlarges the smallest angle of the triangles
 * around.
 *
 * A vertex moves to where RingShape finds a larger angle: as far from the original as before, onto
 * the original, or as found; if none of these is accepted, half of the way.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeMover_h
#define BoneDecimate_Core_Decimate_Stages_ShapeMover_h

#include "Decimate/Edit/Editor.h"
#include "RingShape.h"

namespace bonedecimate
{
class ShapeMover
{
public:
  /// @param enough The cosine of an angle that needs no improvement.
  ShapeMover(Editor& editor, double enough)
    : MeshEditor(editor)
    , Enough(enough)
  {
  }

  /// Flips one edge of the face, the longest that may be.
  void FlipAt(FaceId face);
  /// Moves the corners of the face until it is good enough.
  void MoveAt(FaceId face);
  void Move(VertexId vertex);

  /// For Editor::FlipAndMove.
  EditWorkspace& OwnWorkspace() { return this->Workspace; }

private:
  bool TryFlip(HalfEdgeId edge);

  Editor& MeshEditor;
  double Enough;
  EditWorkspace Workspace;
  RingShape Ring;
};
}

#endif
