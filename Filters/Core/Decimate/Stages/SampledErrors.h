// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledErrors.h
 * @brief The error of every face and vertex as it is now (SampledErrorCost.h), kept up while
 * collapses change it.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SampledErrors_h
#define BoneDecimate_Core_Decimate_Stages_SampledErrors_h

#include "Base/Monitor.h"
#include "FaceError.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <vector>

namespace bonedecimate
{
class SampledErrors
{
public:
  SampledErrors(const HalfEdgeMesh& mesh, const Samples& samples, const OriginalHints& hints);

  /// All of them. False if the monitor said stop.
  bool MeasureAll(int threads, const Monitor& monitor);

  /// The sum of all faces at the edge and of its two ends, squares of the mesh's unit.
  double ErrorAround(const EdgeNeighborhood& around) const;

  /// Raised whenever something around either end has changed.
  std::uint32_t StampOf(HalfEdgeId edge) const
  {
    return this->Stamps[this->Mesh.Origin(edge)] + this->Stamps[this->Mesh.Target(edge)];
  }

  /// After a collapse into the vertex: measures its faces, raises stamps.
  /// @param vertexError Its own, squares of the mesh's unit.
  void AfterCollapse(VertexId vertex, double vertexError);

private:
  double OfFace(FaceId face) const;
  double OfVertex(VertexId vertex) const;

  const HalfEdgeMesh& Mesh;
  const Samples& OriginalSamples;
  const OriginalHints& Hints;
  ErrorPenalty Penalties;
  std::vector<float> FaceErrors;     // error of each, squares of the mesh's unit
  std::vector<float> VertexErrors;   // the same
  std::vector<std::uint32_t> Stamps; // of each vertex, how often something around it has changed
};
}

#endif
