// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexMover.h
 * @brief One Gauss-Newton step of a vertex towards the original, kept only if the sampled two-sided error falls.
 *
 *     gather the samples of the ring's faces and the place of the vertex on the original       (ErrorWeights.h)
 *     solve for the step                                                                       (FitStep.h)
 *     too little to gain:  stay
 *     the error falls there, and no face turns away from the original:  go; else try half the way, then a quarter
 */
#ifndef BoneDecimate_Core_Relax_VertexMover_h
#define BoneDecimate_Core_Relax_VertexMover_h

#include "Collapse/Editor.h"
#include "FaceError.h"
#include "FitStep.h"
#include "Reference/BackHints.h"
#include "Reference/Samples.h"

#include <vector>

namespace bonedecimate
{
class VertexMover
{
public:
  /// @param range What may be changed.
  VertexMover(
    Editor& editor, const Samples& samples, BackHints& hints, VertexRange range, int workers)
    : Work(editor)
    , Fit(samples)
    , Back(hints)
    , Weigh(editor.Mesh().Unit(), samples.Spread())
    , Workers(workers)
  {
    this->Space.Range = range;
  }

  /// True if the vertex moved.
  bool Improve(Index vertex);

private:
  struct RingFace
  {
    Index Face;
    Index Neighbour; // at Second
    Vector3 Second, Third;
    Vector3 Normal;
    double Facing; // cosine between face and original, before the step
  };
  void Gather(Index vertex);
  PlaceOnMesh FindOriginal(Index vertex);
  double AddChords(const Vector3& position, Index hint, FitStep* equations) const;
  double AddSamples(const TriangleFrame& frame, Index face);
  bool Lowers(Index vertex, const Vector3& position);
  double ErrorIfAllowed(const RingFace& ring, const TriangleFrame& frame) const;

  Editor& Work;
  Workspace Space;
  const Samples& Fit;
  BackHints& Back;
  ErrorPenalty Weigh;
  int Workers;
  std::vector<RingFace> Ring;
  std::vector<Index> Neighbours;
  FitStep Equations;
  double Error = 0.0;           // before the step, squares of the mesh's unit
  double SquaredDistance = 0.0; // mm^2, of the vertex to the original
  Vector3 OriginalNormal = Vector3::Zero();
  Index Hint = None;
};
}

#endif
