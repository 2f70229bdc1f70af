// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchFit.h
 * @brief Tries a collapse that exceeds the error bound, with edits around it until the bound is
 * kept, on a copy.
 *
 *     copy the faces around the edge, as after the collapse, and their samples
 *     sweeps:  move each vertex of the copy whose faces use most of the bound by a step of
 *              SlackFit.h; where this does not suffice, flip edges whose other diagonal uses less
 *     success:  all faces are within the bound, and obey the rules of flips and moves against
 *               the faces of the mesh that they replace
 *     failure:  a sweep gains too little
 *
 * The mesh does not change. A success is proposed as one change (Editor::Try), which is proved as a
 * whole.
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
  /// @param rings Number of rings of vertices around the collapse that may move.
  PatchFit(const Editor& editor, const Samples& samples, const OriginalHints& hints, int rings);

  /// The edit, and what to record of it.
  struct Result
  {
    bool IsWithin = false;
    Vector3 Position = Vector3::Zero(); ///< That of the merged vertex, mm from the local origin.
    NearbyEdits Nearby;
    struct Hint
    {
      Index Vertex;
      Index Triangle; ///< A near triangle of the original.
    };
    std::vector<Hint> Hints; ///< Those of the merged and the moved vertices.
    struct SampleOfFace
    {
      Index Face;
      Index Sample;
    };
    std::vector<SampleOfFace> Samples; ///< Samples of all faces of the copy.
    std::vector<Index> Faces;          ///< All faces of the copy and the removed ones.
  };
  /// @param around The neighborhood of the candidate, whose ends move freely.
  Result Fit(const EdgeNeighborhood& around, const SlackCandidate& candidate);

private:
  /// Indices into Vertices and Faces.
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
    std::vector<Corner> Fan; // counter-clockwise; empty if incomplete: cannot move
    bool HasMoved = false;
  };
  struct Face
  {
    Index Id;
    std::vector<SlackFit::Member> Members;
  };
  /// The edge of a vertex to the second corner of a face of its fan, and its two faces. The
  /// vertices are named as by CornersAround().
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
