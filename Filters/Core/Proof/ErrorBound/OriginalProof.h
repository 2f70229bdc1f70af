// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OriginalProof.h
 * @brief Proves that faces of a mesh cover a triangle of the original.
 *
 *     near:    of each corner, the nearest face and faces connected with it within the limit
 *     proved:  one face is within the limit of all three corners, or
 *              the faces near the corners and their neighbors cover it together (CommonFaceProof)
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_OriginalProof_h
#define BoneDecimate_Core_Proof_ErrorBound_OriginalProof_h

#include "CommonFaceProof.h"
#include "CoveringList.h"
#include "ErrorLimits.h"
#include "NearFaces.h"

#include <array>
#include <optional>
#include <vector>

namespace bonedecimate
{
class VertexWalk;

class OriginalProof
{
public:
  /// All must outlive this object.
  OriginalProof(const HalfEdgeMesh& source, const ErrorLimits& limits, const HalfEdgeMesh& mesh);

  /// Finds the faces near the corners of these originals.
  /// @param current For each original vertex, the vertex of the mesh into which it was merged.
  void FindNear(const std::vector<char>& originals, const std::vector<Index>& current, int threads);
  /// Frees the memory of FindNear().
  void ClearNear() { this->FacesNearVertices = std::vector<NearFaces>(); }

  Covering Prove(Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const;

private:
  struct Candidates
  {
    std::array<Index, CommonFaceProof::MaxCandidates> Faces;
    std::size_t Count = 0;

    void Add(Index face);
  };

  NearFaces FindNearFaces(VertexId original, const VertexWalk& walk, VertexId vertex) const;
  Index NearestToAll(const std::array<const NearFaces*, 3>& near) const;
  Covering ProveTogether(Index original, const std::array<const NearFaces*, 3>& near,
    CommonFaceProof& proof, std::optional<Vector3>& far) const;
  Candidates CandidatesOf(Index original, const std::array<const NearFaces*, 3>& near) const;

  const HalfEdgeMesh& OriginalMesh;
  const ErrorLimits& Limits;
  const HalfEdgeMesh& Mesh;
  std::vector<NearFaces> FacesNearVertices; // filled by FindNear()
};
}

#endif
