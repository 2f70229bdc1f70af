// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeFlipper.h
 * @brief Flips an edge where the other diagonal of its two faces lies nearer to the original.
 *
 * The error is that of the samples of the two faces, and of the faces' middles and the edge's middle on the way back.
 * Samples then belong to the nearer of the two new faces.
 */
#ifndef BoneDecimate_Core_Relax_EdgeFlipper_h
#define BoneDecimate_Core_Relax_EdgeFlipper_h

#include "Collapse/Editor.h"
#include "Reference/BackHints.h"
#include "Reference/Samples.h"

namespace bonedecimate
{
class EdgeFlipper
{
public:
  EdgeFlipper(Editor& editor, Samples& samples, BackHints& hints, int workers)
    : Work(editor)
    , Workers(workers)
    , Fit(samples)
    , Back(hints)
  {
  }

  /// Flips edges at the vertex; returns how many.
  Index Improve(Index vertex);

private:
  bool TryFlip(Index edge);
  double SampleError(const TriangleFrame& first, const TriangleFrame& second, Index face) const;
  double BackError(const std::array<Vector3, 3>& corners, Index face, Index& hint) const;

  Editor& Work;
  Workspace Space;
  int Workers;
  Samples& Fit;
  BackHints& Back;
};
}

#endif
