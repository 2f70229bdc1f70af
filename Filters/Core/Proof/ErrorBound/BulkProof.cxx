// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BulkProof.h"

#include "Base/Parallel.h"
#include "Prover.h"
#include "StartOfWalk.h"
#include "WalkedTargets.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
BulkProof::BulkProof(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
  const EditJournal& journal, int threads)
  : Shared(bound)
  , Allowed(limits)
  , Mesh(mesh)
  , Journal(journal)
  , Threads(threads)
  , Originals(bound.Source, limits, mesh)
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
std::vector<Index> BulkProof::FindFailures(const std::vector<Index>& current)
{
  this->FindChanged();
  this->ProveFaces();
  const std::vector<char> originals = this->OriginalsToProve();
  this->Originals.FindNear(originals, current, this->Threads);
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
  this->Originals.ForgetNear();
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
/// Marks originals that are not proved, or were proved by a face that has changed.
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
  return this->Originals.Prove(original, proof, far);
}

//------------------------------------------------------------------------------
/// The last edit of the face nearest to the point that is too far away, or else LastEditAt().
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
/// The last edit around the vertices into which its corners were merged; on the last edit of these
/// more edits depend.
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
