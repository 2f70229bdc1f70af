// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeFlipper.h
 * @brief Flips an edge if the other diagonal of its two faces lies nearer to the samples of both.
 *
 *          c                     c
 *        / | \                 /   \       error before = samples of a-b-c to that face
 *       a  |  b      and      a-----b                     + samples of b-a-d to that face
 *        \ | /                 \   /       error after  = all samples, each to the nearer of
 *          d                     d                        the new faces
 *
 * Either of the two may be the state before. The edge is flipped if this lowers the error, which
 * includes the error of the edge, by 2 % and turns no face away from the original.
 *
 * H. Hoppe et al., Mesh optimization, 1993.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_EdgeFlipper_h
#define BoneDecimate_Core_Decimate_Stages_EdgeFlipper_h

#include "Decimate/Edit/Editor.h"
#include "FaceError.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class EdgeFlipper
{
public:
  /// @param faceErrors The error of each face, squares of the mesh's unit, negative if unknown;
  /// shared by all workers.
  /// @param range The vertices that may be changed.
  EdgeFlipper(Editor& editor, Samples& samples, const OriginalHints& hints,
    std::vector<float>& faceErrors, VertexRange range, int workers)
    : MeshEditor(editor)
    , OriginalSamples(samples)
    , Hints(hints)
    , FaceErrors(faceErrors)
    , Penalties(editor.Mesh().Unit(), samples.MeanValues())
  {
    this->Workspace.Change.Range = range;
    this->Workspace.Change.Workers = workers;
  }

  /// Flips edges at the vertex. Returns the number of flips.
  Index Improve(VertexId vertex);

private:
  /// Two adjacent faces.
  struct Pair
  {
    std::array<Index, 2> Faces;
    std::array<TriangleFrame, 2> Frames;
  };
  bool TryFlip(HalfEdgeId edge);
  double ErrorBefore(const HalfEdgeMesh& mesh, FaceId face);
  double ErrorAfter(const Pair& after, double enough) const;
  double ErrorOfChord(
    const Pair& pair, const std::array<Index, 4>& corners, std::size_t from, std::size_t to) const;
  bool TurnsAway(const std::array<Index, 4>& corners, const Pair& before, const Pair& after) const;
  void HandOver(const Pair& after);

  Editor& MeshEditor;
  EditWorkspace Workspace;
  Samples& OriginalSamples;
  const OriginalHints& Hints;
  std::vector<float>& FaceErrors;
  ErrorPenalty Penalties;
};
}

#endif
