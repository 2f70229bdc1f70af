// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexMover.h
 * @brief One Gauss-Newton step of a vertex towards the original, kept only if the sampled error in
 * both directions falls.
 *
 *     gather the samples of the faces of the ring, and the nearest point of the original
 *     solve for the step                                                        (FitStep.h)
 *     too little to gain:  do not move
 *     the error falls and no face turns away from the original:  move  (SampledErrorCost.h)
 *     otherwise, try half of the step, then a quarter
 */
#ifndef BoneDecimate_Core_Decimate_Stages_VertexMover_h
#define BoneDecimate_Core_Decimate_Stages_VertexMover_h

#include "Decimate/Edit/Editor.h"
#include "FaceError.h"
#include "FitStep.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <vector>

namespace bonedecimate
{
class VertexMover
{
public:
  /// @param range The vertices that may be changed.
  VertexMover(
    Editor& editor, const Samples& samples, OriginalHints& hints, VertexRange range, int workers)
    : MeshEditor(editor)
    , OriginalSamples(samples)
    , Hints(hints)
    , Penalties(editor.Mesh().Unit(), samples.MeanValues())
  {
    this->Workspace.Change.Range = range;
    this->Workspace.Change.Workers = workers;
  }

  /// Whether the vertex moved.
  bool Improve(VertexId vertex);

private:
  struct RingFace
  {
    Index Face;
    Index Neighbor; // at Second
    Vector3 Second, Third;
    Vector3 Normal;
    double Facing; // cosine of the angle to the original before the step
  };
  void Gather(VertexId vertex);
  PointOnMesh FindOriginal(VertexId vertex);
  double AddChords(const Vector3& position, Index hint, FitStep* equations) const;
  double AddSamples(const TriangleFrame& frame, FaceId face);
  bool LowersError(VertexId vertex, const Vector3& position);
  double ErrorIfAllowed(const RingFace& ring, const TriangleFrame& frame) const;

  Editor& MeshEditor;
  EditWorkspace Workspace;
  const Samples& OriginalSamples;
  OriginalHints& Hints;
  ErrorPenalty Penalties;
  std::vector<RingFace> Ring;
  std::vector<Index> Neighbors;
  FitStep Equations;
  double Error = 0.0;           // before the step, squares of the mesh's unit
  double SquaredDistance = 0.0; // mm^2, of the vertex to the original
  Vector3 OriginalNormal = Vector3::Zero();
  Index Hint = None;
};
}

#endif
