// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FanFit.h
 * @brief The change of the sampled error by a collapse, and the best position of the merged vertex.
 *
 *     gather the samples of all faces at the edge
 *     x  = the minimum of the quadrics of the ends
 *     x' = x + one Gauss-Newton step by the samples, each on its face of the fan around x
 *     take the better position                              (error of SampledErrorCost.h)
 *
 * A sample is first assigned to the new face that replaces its old one, and moves on around the fan
 * while its distance decreases.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FanFit_h
#define BoneDecimate_Core_Decimate_Stages_FanFit_h

#include "Decimate/Edit/Editor.h"
#include "FaceError.h"
#include "FitStep.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <vector>

namespace bonedecimate
{
class FanFit
{
public:
  FanFit(const HalfEdgeMesh& mesh, const Samples& samples, const OriginalHints& hints)
    : Mesh(mesh)
    , OriginalSamples(samples)
    , Hints(hints)
    , Penalties(mesh.Unit(), samples.MeanValues())
  {
  }

  struct Result
  {
    double Error = 0.0; // of the new fan, squares of the mesh's unit
    Vector3 Position = Vector3::Zero();
    Index Hint = None;        // an original triangle near the position
    double VertexError = 0.0; // the part of Error that is due to the vertex
  };
  /// @param around That of an edge with two inner ends.  @param position Initial position, x.
  Result Evaluate(const EdgeNeighborhood& around, const Vector3& position);

  /// A sample of the old faces and the face of the fan that it belongs to, after Evaluate().
  struct Member
  {
    Index Sample;
    std::size_t Slot; // in around.Corners
  };
  const std::vector<Member>& Members() const { return this->SampleMembers; }

private:
  void Gather(const EdgeNeighborhood& around);
  void GatherFace(FaceId face, std::size_t slot);
  void Build(const EdgeNeighborhood& around, const Vector3& x);
  Result EvaluateAt(const EdgeNeighborhood& around, const Vector3& x, FitStep* step);
  double ErrorOfChords(const EdgeNeighborhood& around, const Result& result) const;
  void AddVertex(const EdgeNeighborhood& around, Result& result, FitStep* step) const;

  const HalfEdgeMesh& Mesh;
  const Samples& OriginalSamples;
  const OriginalHints& Hints;
  ErrorPenalty Penalties;
  std::vector<Member> SampleMembers;
  std::vector<TriangleFrame> Frames;
};
}

#endif
