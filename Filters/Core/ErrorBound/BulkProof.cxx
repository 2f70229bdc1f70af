// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BulkProof.h"

#include "Parallel.h"
#include "Prover.h"
#include "WalkedTargets.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Of an original, as in Prover.cxx.
constexpr std::size_t MostPieces = 256;
/// Faces that are looked at around an original vertex.
constexpr std::size_t MostAround = 40;

std::array<Vector3, 3> PositionsOf(const HalfEdgeMesh& mesh, FaceId face)
{
  const Triangle c = mesh.Corners(face);
  return { mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]) };
}
}

BulkProof::BulkProof(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
  const EditJournal& journal, int threads)
  : Shared(bound)
  , Allowed(limits)
  , Mesh(mesh)
  , Journal(journal)
  , Threads(threads)
  , Found(bound.Source.NumberOfFaceSlots())
  , ProvedVersion(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
  , IsChanged(ProvedVersion.size(), 0)
  , IsFaceProved(ProvedVersion.size(), 1)
{
  for (std::size_t original = 0; !bound.ByFaces.IsEmpty() && original < this->Found.Count();
       ++original)
  {
    this->Found.Set(original, this->CoveringAtFirst(static_cast<Index>(original)));
  }
}

//------------------------------------------------------------------------------
void BulkProof::Candidates::Add(Index face)
{
  const auto end = this->Faces.begin() + static_cast<std::ptrdiff_t>(this->Count);
  if (this->Count < this->Faces.size() && std::find(this->Faces.begin(), end, face) == end)
  {
    this->Faces[this->Count++] = face;
  }
}

//------------------------------------------------------------------------------
std::vector<Index> BulkProof::FindFailures(const std::vector<Index>& current)
{
  this->FindChanged();
  this->ProveFaces();
  const std::vector<char> originals = this->OriginalsToProve();
  this->FindNear(originals, current);
  this->ProveOriginals(originals);
  std::vector<Index> edits;
  for (FaceId face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
  {
    if (this->IsFaceProved[face] == 0)
    {
      edits.push_back(this->Journal.LastOfFace(face));
    }
    this->ProvedVersion[face] = this->Journal.LastOfFace(face);
  }
  for (const Failure& failure : this->Failures)
  {
    edits.push_back(this->EditToUndo(failure, current));
  }
  return edits;
}

//------------------------------------------------------------------------------
void BulkProof::ProveOriginals(const std::vector<char>& originals)
{
  struct Part
  {
    std::vector<std::pair<std::size_t, Covering>> BySeveral; // faces
    std::vector<Failure> Failures;
  };
  std::vector<Part> parts(NumberOfChunks(originals.size()));
  ForEachChunk(originals.size(), this->Threads, {},
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      CommonFaceProof proof;
      for (std::size_t i = first; i < last; ++i)
      {
        if (originals[i] != 0)
        {
          Failure failure = { static_cast<Index>(i), {} };
          const Covering covering = this->Prove(failure.Original, proof, failure.Far);
          if (covering.IsOneFace())
          {
            this->Found.Set(i, covering);
          }
          else
          {
            parts[chunk].BySeveral.emplace_back(i, covering);
          }
          if (!covering.IsProved)
          {
            parts[chunk].Failures.push_back(failure);
          }
        }
      }
    });
  this->Failures.clear();
  for (const Part& part : parts)
  {
    for (const auto& [original, covering] : part.BySeveral)
    {
      this->Found.Set(original, covering);
    }
    this->Failures.insert(this->Failures.end(), part.Failures.begin(), part.Failures.end());
  }
  this->Near = std::vector<NearFaces>();
}

//------------------------------------------------------------------------------
void BulkProof::FindChanged()
{
  for (FaceId face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
  {
    this->IsChanged[face] = this->Journal.LastOfFace(face) != this->ProvedVersion[face] ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void BulkProof::ProveFaces()
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Allowed);
  ForEachChunk(this->IsChanged.size(), this->Threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const std::shared_ptr<Prover> prover = this->Shared.BorrowProver();
      FaceProof& proof = prover->Back;
      for (std::size_t i = first; i < last; ++i)
      {
        const FaceId face = static_cast<Index>(i);
        if (this->IsChanged[i] != 0)
        {
          const bool isThere = this->Mesh.IsAlive(face) && this->Journal.IsChanged(face);
          this->IsFaceProved[i] = !isThere ||
              proof.Prove(original, PositionsOf(this->Mesh, face),
                this->Shared.Nearest[this->Mesh.Corners(face)[0]])
            ? 1
            : 0;
        }
      }
    });
  this->Shared.Provers.Clear(); // what follows needs the memory
}

//------------------------------------------------------------------------------
/// Those that are not proved, and those proved by a face that has changed.
std::vector<char> BulkProof::OriginalsToProve() const
{
  std::vector<char> originals(this->Found.Count(), 0);
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    const Covering covering = this->Found.Of(i);
    const auto end = covering.Faces.begin() + covering.Count;
    const bool hasChanged = std::any_of(
      covering.Faces.begin(), end, [this](Index face) { return this->IsChanged[face] != 0; });
    originals[i] = hasChanged || !covering.IsProved ? 1 : 0;
  }
  return originals;
}

//------------------------------------------------------------------------------
void BulkProof::FindNear(const std::vector<char>& originals, const std::vector<Index>& current)
{
  this->Near.resize(static_cast<std::size_t>(this->Shared.Source.NumberOfVertexSlots()));
  std::vector<char> isCorner(this->Near.size(), 0);
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    if (originals[i] != 0)
    {
      for (const Index corner : this->Shared.Source.Corners(static_cast<Index>(i)))
      {
        isCorner[corner] = 1;
      }
    }
  }
  const StartOfWalk starts(this->Mesh);
  ForEachId(isCorner.size(), this->Threads,
    [&](std::size_t v)
    {
      if (isCorner[v] != 0)
      {
        this->Near[v] = this->NearTo(static_cast<Index>(v), starts, current[v]);
      }
    });
}

//------------------------------------------------------------------------------
/// The nearest face, and those connected with it by faces within the limit.
NearFaces BulkProof::NearTo(VertexId original, const StartOfWalk& starts, VertexId vertex) const
{
  const Vector3& p = this->Shared.Source.Position(original);
  const double limit = this->Allowed.At(original);
  NearFaces near;
  std::array<Index, MostAround> around;
  std::size_t count = 0;
  const auto add = [&](FaceId face)
  {
    const auto end = around.begin() + static_cast<std::ptrdiff_t>(count);
    if (count < MostAround && std::find(around.begin(), end, Index(face)) == end)
    {
      const double squared = FrameOf(this->Mesh, face).SquaredReach(p);
      if (squared <= limit * limit)
      {
        around[count++] = face;
        near.Insert(face, static_cast<float>(squared));
      }
    }
  };
  add(starts.FindNear(p, vertex).Face);
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
Covering BulkProof::CoveringAtFirst(Index original) const
{
  Covering covering;
  if (this->Shared.ByFaces.IsEmpty())
  {
    covering.Faces[0] = original;
    covering.Count = 1;
    return covering;
  }
  for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
  {
    const Index face = this->Shared.ByFaces.CoveringElement(original, slot);
    if (face != None)
    {
      covering.Faces[static_cast<std::size_t>(covering.Count++)] = face;
    }
  }
  return covering;
}

//------------------------------------------------------------------------------
bool BulkProof::IsAsAtFirst(const Covering& covering) const
{
  return covering.Count > 0 &&
    std::none_of(covering.Faces.begin(), covering.Faces.begin() + covering.Count,
      [this](Index face) { return this->Journal.IsChanged(face); });
}

//------------------------------------------------------------------------------
Covering BulkProof::Prove(Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const
{
  Covering covering = this->CoveringAtFirst(original);
  if (this->IsAsAtFirst(covering))
  {
    return covering;
  }
  const Triangle corners = this->Shared.Source.Corners(original);
  const std::array<const NearFaces*, 3> near = { &this->Near[corners[0]], &this->Near[corners[1]],
    &this->Near[corners[2]] };
  const Index face = this->NearestToAll(near);
  if (face == None)
  {
    return this->ProveTogether(original, near, proof, far);
  }
  covering.Faces[0] = face;
  covering.Count = 1;
  return covering;
}

//------------------------------------------------------------------------------
/// Of the faces near all three corners the one with the least sum of squared distances; None if there is none.
Index BulkProof::NearestToAll(const std::array<const NearFaces*, 3>& near) const
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
      const float sum = near[0]->Squared[at] + near[1]->Squared[static_cast<std::size_t>(second)] +
        near[2]->Squared[static_cast<std::size_t>(third)];
      nearest = sum < least ? face : nearest;
      least = std::min(least, sum);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
/// Those near the corners, and of their neighbors those that may be near the inside alone.
BulkProof::Candidates BulkProof::CandidatesOf(
  Index original, const std::array<const NearFaces*, 3>& near) const
{
  const std::array<Vector3, 3> p = PositionsOf(this->Shared.Source, original);
  const Triangle corners = this->Shared.Source.Corners(original);
  const Vector3 middle = (p[0] + p[1] + p[2]) / 3.0;
  double reach = 0.0; // mm
  Candidates candidates;
  for (std::size_t k = 0; k < 3; ++k)
  {
    reach = std::max(reach, (p[k] - middle).norm() + this->Allowed.At(corners[k]));
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
Covering BulkProof::ProveTogether(Index original, const std::array<const NearFaces*, 3>& near,
  CommonFaceProof& proof, std::optional<Vector3>& far) const
{
  const Candidates candidates = this->CandidatesOf(original, near);
  proof.Resize(0);
  for (std::size_t i = 0; i < candidates.Count; ++i)
  {
    proof.AddCandidate(PositionsOf(this->Mesh, candidates.Faces[i]));
  }
  const Triangle corners = this->Shared.Source.Corners(original);
  CommonFaceProof::Piece whole;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3& p = this->Shared.Source.Position(corners[k]);
    const double limit = this->Allowed.At(corners[k]);
    whole[k] = { p, limit, proof.FacesNear(p, limit) };
  }
  CommonFaceProof::Faces used = 0;
  Covering covering;
  const CommonFaceResult result = proof.Prove(whole, used, MostPieces);
  covering.IsProved =
    result == CommonFaceResult::Proved && CountBits(used) <= Coverage::SlotsPerItem;
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

//------------------------------------------------------------------------------
/// That of the face nearest to a point that is too far away, if there is one.
Index BulkProof::EditToUndo(const Failure& failure, const std::vector<Index>& current) const
{
  Index edit = None;
  if (failure.Far)
  {
    const VertexId corner = this->Shared.Source.Corners(failure.Original)[0];
    const StartOfWalk starts(this->Mesh);
    edit = this->Journal.LastOfFace(starts.FindNear(*failure.Far, current[corner]).Face);
  }
  return edit != None ? edit : this->LastEditAt(failure.Original, current);
}

//------------------------------------------------------------------------------
/// The last edit around the vertices into which its corners were merged; on the last edit of these more edits depend.
Index BulkProof::LastEditAt(Index original, const std::vector<Index>& current) const
{
  Index last = None;
  const auto look = [&](Index face) { last = std::max(last, this->Journal.LastOfFace(face)); };
  for (const Index corner : this->Shared.Source.Corners(original))
  {
    const VertexId v = current[corner];
    if (this->Mesh.MovesFreely(v))
    {
      for (const HalfEdgeId h : this->Mesh.OutgoingOf(v))
      {
        look(HalfEdgeMesh::Face(h));
      }
    }
  }
  if (last == None)
  {
    const Covering covering = this->CoveringAtFirst(original);
    std::for_each(covering.Faces.begin(), covering.Faces.begin() + covering.Count, look);
  }
  return last;
}

//------------------------------------------------------------------------------
void BulkProof::WriteCoverage()
{
  this->Shared.ByFaces = {}; // two at a time would need their memory
  this->Shared.ByFaces = this->Found.ToCoverage(this->Mesh.NumberOfFaceSlots());
}
}
