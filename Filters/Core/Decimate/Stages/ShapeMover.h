// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeMover.h
 * @brief Flips edges and moves vertices where this enlarges the smallest angle of the triangles
 * around them.
 *
 * RingShape finds a position with a larger angle. It is tried as far from the original as the
 * vertex was, on the original, and as found. If none of these is accepted, half of the way is
 * tried.
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

  /// Flips the longest edge of the face that can be flipped.
  void FlipAt(FaceId face);
  /// Moves the corners of the face until its angles are large enough.
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
