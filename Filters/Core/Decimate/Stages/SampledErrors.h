// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledErrors.h
 * @brief The current error of every face and vertex (SampledErrorCost.h), updated as edges are
 * collapsed.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SampledErrors_h
#define BoneDecimate_Core_Decimate_Stages_SampledErrors_h

#include "Base/Monitor.h"
#include "FaceError.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
class SampledErrors
{
public:
  SampledErrors(const HalfEdgeMesh& mesh, const Samples& samples, const OriginalHints& hints);

  /// Measures all errors. False if the monitor requests a stop.
  bool MeasureAll(int threads, const Monitor& monitor);

  /// The sum over all faces at the edge and its two ends, squares of the mesh's unit.
  double ErrorAround(const EdgeNeighborhood& around) const;

  /// A number that increases whenever something around either end changes.
  std::uint32_t StampOf(HalfEdgeId edge) const
  {
    return this->Stamps[this->Mesh.Origin(edge)] + this->Stamps[this->Mesh.Target(edge)];
  }

  /// Measures the faces of a merged vertex and increases stamps.
  /// @param vertexError Error of the vertex, squares of the mesh's unit.
  void AfterCollapse(VertexId vertex, double vertexError);

private:
  double OfFace(FaceId face) const;
  double OfVertex(VertexId vertex) const;

  const HalfEdgeMesh& Mesh;
  const Samples& OriginalSamples;
  const OriginalHints& Hints;
  ErrorPenalty Penalties;
  std::vector<float> FaceErrors;     // squares of the mesh's unit
  std::vector<float> VertexErrors;   // squares of the mesh's unit
  std::vector<std::uint32_t> Stamps; // number of changes around each vertex
};
}

#endif
