// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchFit.h
 * @brief Tries a collapse that exceeds the error bound, and edits around it until the bound is
 * kept, on a copy.
 *
 *     copy the faces around the edge, as after the collapse, and their samples
 *     sweeps: each vertex of the copy whose faces use most of the bound takes the step of
 *       SlackFit.h,
 *             and where that does not suffice, its edges are flipped if their other diagonal uses
 *               less
 *     no face breaks the rules of flips and moves against the face of the mesh that it replaces
 *     all faces within the bound:   found
 *     a sweep gains too little:     given up
 *
 * The mesh does not change. What is found is proposed as one change (Editor::Try), which is proved
 * as a whole.
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
  /// @param rings How many rings of vertices around the collapse that may move.
  PatchFit(const Editor& editor, const Samples& samples, const OriginalHints& hints, int rings);

  /// What the edit is, and what to record of it.
  struct Result
  {
    bool IsWithin = false;
    Vector3 Position = Vector3::Zero(); ///< Where the merged vertex is, mm from the local origin.
    NearbyEdits Nearby;
    struct Hint
    {
      Index Vertex;
      Index Triangle; ///< A triangle of the original.
    };
    std::vector<Hint> Hints; ///< What is near the merged and the moved vertices.
    struct SampleOfFace
    {
      Index Face;
      Index Sample;
    };
    std::vector<SampleOfFace> Samples; ///< Samples of all faces of the copy.
    std::vector<Index> Faces;          ///< All faces of the copy, the removed ones included.
  };
  /// @param around What is around the edge of the candidate; its ends move freely.
  Result Fit(const EdgeNeighborhood& around, const SlackCandidate& candidate);

private:
  /// Positions in Vertices and Faces.
  struct Corner
  {
    std::size_t Face;
    std::size_t Second;
    std::size_t Third;
  };
  struct Vertex
  {
    Index Id;
    Vector3 Position;
    Index Hint;
    std::vector<Corner> Fan; // counter-clockwise; empty where the copy ends: nothing moves
    bool HasMoved = false;
  };
  struct Face
  {
    Index Id;
    std::vector<SlackFit::Member> Members;
  };
  /// The edge of a vertex to the second corner of a face of its fan, and its two faces, as
  /// CornersAround names them.
  struct Edge
  {
    std::size_t A, B, C, D;
    std::size_t Left, Right; // faces
  };
  void Copy(const EdgeNeighborhood& around, const SlackCandidate& candidate);
  void CopyRing(VertexId vertex, const EdgeNeighborhood& around);
  void CopySamples(const EdgeNeighborhood& around);
  std::size_t FaceOf(Index id);
  std::size_t VertexOf(Index id);
  SlackFit::Value Evaluate(const Vertex& vertex, const Vector3& position, double enough);
  void HandOver(const Vertex& vertex);
  Index NumberOfBadFaces(const Vertex& vertex) const;
  double Improve(Vertex& vertex);
  Edge EdgeAt(std::size_t vertex, std::size_t slot) const;
  bool FlipIsAllowed(const Edge& edge) const;
  void GatherPair(
    const std::array<std::size_t, 4>& corners, const std::array<std::size_t, 2>& faces);
  bool FlipImproves(const Edge& edge);
  void Flip(const Edge& edge);
  void FlipAround(std::size_t vertex, double ratio);
  double MaxRatio();
  double Sweep();
  bool SweepUntilWithin();
  Result MakeResult(const EdgeNeighborhood& around) const;

  int Rings;
  const HalfEdgeMesh& Mesh;
  const OriginalHints& Hints;
  SlackFit Slack;
  std::vector<Vertex> Vertices; // the merged one first
  std::vector<Face> Faces;
  std::vector<EdgeFlip> Flips;
};
}

#endif
