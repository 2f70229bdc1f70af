// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OriginalProof.h"

#include "Base/Parallel.h"
#include "VertexWalk.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Faces that are searched around an original vertex.
constexpr std::size_t MaxAround = 40;
}

OriginalProof::OriginalProof(
  const HalfEdgeMesh& source, const ErrorLimits& limits, const HalfEdgeMesh& mesh)
  : OriginalMesh(source)
  , Limits(limits)
  , Mesh(mesh)
{
}

//------------------------------------------------------------------------------
void OriginalProof::Candidates::Add(Index face)
{
  const auto end = this->Faces.begin() + static_cast<std::ptrdiff_t>(this->Count);
  if (this->Count < this->Faces.size() && std::find(this->Faces.begin(), end, face) == end)
  {
    this->Faces[this->Count++] = face;
  }
}

//------------------------------------------------------------------------------
void OriginalProof::FindNear(
  const std::vector<char>& originals, const std::vector<Index>& current, int threads)
{
  this->FacesNearVertices.resize(
    static_cast<std::size_t>(this->OriginalMesh.NumberOfVertexSlots()));
  std::vector<char> isCorner(this->FacesNearVertices.size(), 0);
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    if (originals[i] != 0)
    {
      for (const Index corner : this->OriginalMesh.Corners(static_cast<Index>(i)))
      {
        isCorner[corner] = 1;
      }
    }
  }
  const VertexWalk walk(this->Mesh);
  ForEachId(isCorner.size(), threads,
    [&](std::size_t v)
    {
      if (isCorner[v] != 0)
      {
        this->FacesNearVertices[v] = this->FindNearFaces(static_cast<Index>(v), walk, current[v]);
      }
    });
}

//------------------------------------------------------------------------------
/// The nearest face, and those connected with it by faces within the limit.
NearFaces OriginalProof::FindNearFaces(
  VertexId original, const VertexWalk& walk, VertexId vertex) const
{
  const Vector3& p = this->OriginalMesh.Position(original);
  const double limit = this->Limits.At(original);
  NearFaces near;
  std::array<Index, MaxAround> around;
  std::size_t count = 0;
  const auto add = [&](FaceId face)
  {
    const auto end = around.begin() + static_cast<std::ptrdiff_t>(count);
    if (count < MaxAround && std::find(around.begin(), end, Index(face)) == end)
    {
      const double squared = FrameOf(this->Mesh, face).SquaredReach(p);
      if (squared <= limit * limit)
      {
        around[count++] = face;
        near.Insert(face, static_cast<float>(squared));
      }
    }
  };
  add(walk.FindNear(p, vertex).Face);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      const HalfEdgeId twin = this->Mesh.Twin(HalfEdgeMesh::HalfEdge(around[i], corner));
      if (twin != None)
      {
        add(HalfEdgeMesh::Face(twin));
      }
    }
  }
  return near;
}

//------------------------------------------------------------------------------
/// @param far Set to a point that is near no face, if one was found and none covers it.
Covering OriginalProof::Prove(
  Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const
{
  const Triangle corners = this->OriginalMesh.Corners(original);
  const std::array<const NearFaces*, 3> near = { &this->FacesNearVertices[corners[0]],
    &this->FacesNearVertices[corners[1]], &this->FacesNearVertices[corners[2]] };
  Covering covering;
  covering.Faces[0] = this->NearestToAll(near);
  covering.Count = 1;
  return covering.Faces[0] != None ? covering : this->ProveTogether(original, near, proof, far);
}

//------------------------------------------------------------------------------
/// The face near all three corners that has the least sum of squared distances; None if there is no
/// such face.
Index OriginalProof::NearestToAll(const std::array<const NearFaces*, 3>& near) const
{
  Index nearest = None;
  float least = std::numeric_limits<float>::infinity();
  for (int i = 0; i < near[0]->Count; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const Index face = near[0]->Faces[at];
    const int second = near[1]->Find(face);
    const int third = near[2]->Find(face);
    if (second != None && third != None)
    {
      const float sum = near[0]->SquaredDistances[at] +
        near[1]->SquaredDistances[static_cast<std::size_t>(second)] +
        near[2]->SquaredDistances[static_cast<std::size_t>(third)];
      nearest = sum < least ? face : nearest;
      least = std::min(least, sum);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
/// Faces near the corners, and their neighbors that may be near the interior.
OriginalProof::Candidates OriginalProof::CandidatesOf(
  Index original, const std::array<const NearFaces*, 3>& near) const
{
  const std::array<Vector3, 3> p = PositionsOf(this->OriginalMesh, original);
  const Triangle corners = this->OriginalMesh.Corners(original);
  const Vector3 middle = (p[0] + p[1] + p[2]) / 3.0;
  double reach = 0.0; // mm
  Candidates candidates;
  for (std::size_t k = 0; k < 3; ++k)
  {
    reach = std::max(reach, (p[k] - middle).norm() + this->Limits.At(corners[k]));
    std::for_each(near[k]->Faces.begin(), near[k]->Faces.begin() + near[k]->Count,
      [&](Index face) { candidates.Add(face); });
  }
  const std::size_t atCorners = candidates.Count;
  for (std::size_t i = 0; i < atCorners; ++i)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      const HalfEdgeId twin = this->Mesh.Twin(HalfEdgeMesh::HalfEdge(candidates.Faces[i], corner));
      if (twin != None &&
        FrameOf(this->Mesh, HalfEdgeMesh::Face(twin)).SquaredReach(middle) <= reach * reach)
      {
        candidates.Add(HalfEdgeMesh::Face(twin));
      }
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
/// @param far Set to a point that is near no face, if one was found.
Covering OriginalProof::ProveTogether(Index original, const std::array<const NearFaces*, 3>& near,
  CommonFaceProof& proof, std::optional<Vector3>& far) const
{
  const Candidates candidates = this->CandidatesOf(original, near);
  proof.Resize(0);
  for (std::size_t i = 0; i < candidates.Count; ++i)
  {
    proof.AddCandidate(PositionsOf(this->Mesh, candidates.Faces[i]));
  }
  const Triangle corners = this->OriginalMesh.Corners(original);
  CommonFaceProof::Piece whole;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3& p = this->OriginalMesh.Position(corners[k]);
    const double limit = this->Limits.At(corners[k]);
    whole[k] = { p, limit, proof.FacesNear(p, limit) };
  }
  CommonFaceProof::Faces used = 0;
  Covering covering;
  const CommonFaceResult result = proof.Prove(whole, used, CommonFaceProof::MaxPieces);
  covering.IsProved =
    result == CommonFaceResult::Proved && CountBits(used) <= Coverage::SlotsPerElement;
  if (result == CommonFaceResult::TooFar)
  {
    far = proof.FarPosition();
  }
  for (std::size_t i = 0; i < candidates.Count && covering.IsProved; ++i)
  {
    if ((used >> i & 1) != 0)
    {
      covering.Faces[static_cast<std::size_t>(covering.Count++)] = candidates.Faces[i];
    }
  }
  return covering;
}
}
