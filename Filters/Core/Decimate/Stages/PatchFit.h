// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchFit.h
 * @brief Tries a collapse that exceeds the error bound, and moves of the vertices around it until the bound is kept, on a copy.
 *
 *     copy the faces around the edge, as after the collapse, and their samples
 *     sweeps: each vertex of the copy whose faces use most of the bound takes the step of SlackFit.h
 *     all faces within the bound:   found
 *     a sweep gains too little:     given up
 *
 * The mesh does not change. What is found is proposed as one edit (Editor::CollapseAndMove), which is proved as a whole.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_PatchFit_h
#define BoneDecimate_Core_Decimate_Stages_PatchFit_h

#include "Decimate/Edit/Editor.h"
#include "SlackCandidates.h"
#include "SlackFit.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class PatchFit
{
public:
  PatchFit(const Editor& editor, const Samples& samples, const BackHints& hints);

  /// What the edit is, and what to record of it.
  struct Result
  {
    bool IsWithin = false;
    Vector3 Position = Vector3::Zero(); ///< Of the merged vertex, mm from the local origin.
    std::vector<VertexMove> Moves;
    struct Near
    {
      Index Vertex;
      Index Triangle; ///< Of the original.
    };
    std::vector<Near> Hints; ///< Of the merged and of the moved vertices.
    struct Held
    {
      Index Face;
      Index Sample;
    };
    std::vector<Held> Samples; ///< Of all faces of the copy.
    std::vector<Index> Faces;  ///< All faces of the copy, the removed ones included.
  };
  /// @param around Of the candidate, whose ends move freely.
  Result Fit(const EdgeNeighborhood& around, const SlackCandidate& candidate);

private:
  struct Corner
  {
    std::size_t Face; // in Faces
    Index Second;     // vertices
    Index Third;
  };
  struct Vertex
  {
    Index Id;
    Vector3 Position;
    Index Hint;
    std::vector<Corner> Fan;
    bool HasMoved = false;
  };
  struct Face
  {
    Index Id;
    std::vector<SlackFit::Member> Members;
  };
  void Copy(const EdgeNeighborhood& around, const SlackCandidate& candidate);
  void CopyRing(VertexId vertex, const EdgeNeighborhood& around);
  void CopySamples(const EdgeNeighborhood& around);
  std::size_t FaceOf(Index id);
  const Vector3& PositionOf(Index vertex) const;
  SlackFit::Value Evaluate(const Vertex& vertex, const Vector3& position, double enough);
  void HandOver(const Vertex& vertex);
  double Improve(Vertex& vertex);
  double LargestRatio();
  bool SweepUntilWithin();
  Result Found(const EdgeNeighborhood& around) const;

  const HalfEdgeMesh& Mesh;
  const BackHints& Back;
  SlackFit Slack;
  std::vector<Vertex> Vertices; // that may move: the merged one first
  std::vector<Face> Faces;
};
}

#endif
