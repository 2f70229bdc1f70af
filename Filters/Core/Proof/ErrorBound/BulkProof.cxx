// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BulkProof.h"

#include "Base/Parallel.h"
#include "Prover.h"
#include "VertexWalk.h"
#include "WalkedTargets.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
BulkProof::BulkProof(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
  const EditJournal& journal, int threads)
  : Bound(bound)
  , Limits(limits)
  , Mesh(mesh)
  , Journal(journal)
  , Threads(threads)
  , ProofOfOriginals(bound.OriginalMesh, limits, mesh)
  , Coverings(bound.OriginalMesh.NumberOfFaceSlots())
  , ProvedVersion(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
  , IsChanged(ProvedVersion.size(), 0)
  , IsFaceProved(ProvedVersion.size(), 1)
{
  for (std::size_t original = 0;
       !bound.FaceCoverage.IsEmpty() && original < this->Coverings.Count(); ++original)
  {
    this->Coverings.Set(original, this->InitialCovering(static_cast<Index>(original)));
  }
}

//------------------------------------------------------------------------------
std::optional<std::vector<Index>> BulkProof::FindFailures(
  const std::vector<Index>& current, const Monitor& monitor)
{
  this->FindChanged();
  if (!this->ProveFaces(monitor))
  {
    return std::nullopt;
  }
  const std::vector<char> originals = this->OriginalsToProve();
  this->ProofOfOriginals.FindNear(originals, current, this->Threads);
  if (!this->ProveOriginals(originals, monitor))
  {
    return std::nullopt;
  }
  std::vector<Index> edits;
  for (FaceId face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
  {
    if (this->IsFaceProved[face] == 0)
    {
      edits.push_back(this->Journal.LastEditOf(face));
    }
    this->ProvedVersion[face] = this->Journal.LastEditOf(face);
  }
  for (const Failure& failure : this->Failures)
  {
    edits.push_back(this->EditToUndo(failure, current));
  }
  return edits;
}

//------------------------------------------------------------------------------
/// False after an abort by the monitor, which may be empty.
bool BulkProof::ProveOriginals(const std::vector<char>& originals, const Monitor& monitor)
{
  struct Part
  {
    std::vector<std::pair<std::size_t, Covering>> BySeveral; // faces
    std::vector<Failure> Failures;
  };
  std::vector<Part> parts(NumberOfChunks(originals.size()));
  const bool isDone = ForEachChunk(originals.size(), this->Threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      CommonFaceProof proof;
      for (std::size_t i = first; i < last; ++i)
      {
        if (originals[i] != 0)
        {
          Failure failure = { static_cast<Index>(i), {} };
          const Covering covering = this->Prove(failure.Triangle, proof, failure.FarPosition);
          if (covering.IsOneFace())
          {
            this->Coverings.Set(i, covering);
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
      this->Coverings.Set(original, covering);
    }
    this->Failures.insert(this->Failures.end(), part.Failures.begin(), part.Failures.end());
  }
  this->ProofOfOriginals.ClearNear();
  return isDone;
}

//------------------------------------------------------------------------------
void BulkProof::FindChanged()
{
  for (FaceId face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
  {
    this->IsChanged[face] = this->Journal.LastEditOf(face) != this->ProvedVersion[face] ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
/// False after an abort by the monitor.
bool BulkProof::ProveFaces(const Monitor& monitor)
{
  const WalkedSurface original(this->Bound.OriginalMesh, this->Bound.OriginalTree, this->Limits);
  const bool isDone = ForEachChunk(this->IsChanged.size(), this->Threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const std::shared_ptr<Prover> prover = this->Bound.BorrowProver();
      FaceProof& proof = prover->NewFaceProof;
      for (std::size_t i = first; i < last; ++i)
      {
        const FaceId face = static_cast<Index>(i);
        if (this->IsChanged[i] != 0)
        {
          const bool isThere = this->Mesh.IsAlive(face) && this->Journal.IsChanged(face);
          this->IsFaceProved[i] = !isThere ||
              proof.Prove(original, PositionsOf(this->Mesh, face),
                this->Bound.NearTriangles[this->Mesh.Corners(face)[0]])
            ? 1
            : 0;
        }
      }
    });
  this->Bound.Provers.Clear(); // frees their memory for the next step
  return isDone;
}

//------------------------------------------------------------------------------
/// Marks originals that are not proved, or of which a covering face has changed.
std::vector<char> BulkProof::OriginalsToProve() const
{
  std::vector<char> originals(this->Coverings.Count(), 0);
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    const Covering covering = this->Coverings.Of(i);
    const auto end = covering.Faces.begin() + covering.Count;
    const bool hasChanged = std::any_of(
      covering.Faces.begin(), end, [this](Index face) { return this->IsChanged[face] != 0; });
    originals[i] = hasChanged || !covering.IsProved ? 1 : 0;
  }
  return originals;
}

//------------------------------------------------------------------------------
Covering BulkProof::InitialCovering(Index original) const
{
  Covering covering;
  if (this->Bound.FaceCoverage.IsEmpty())
  {
    covering.Faces[0] = original;
    covering.Count = 1;
    return covering;
  }
  for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
  {
    const Index face = this->Bound.FaceCoverage.CoveringElement(original, slot);
    if (face != None)
    {
      covering.Faces[static_cast<std::size_t>(covering.Count++)] = face;
    }
  }
  return covering;
}

//------------------------------------------------------------------------------
bool BulkProof::IsUnchanged(const Covering& covering) const
{
  return covering.Count > 0 &&
    std::none_of(covering.Faces.begin(), covering.Faces.begin() + covering.Count,
      [this](Index face) { return this->Journal.IsChanged(face); });
}

//------------------------------------------------------------------------------
Covering BulkProof::Prove(Index original, CommonFaceProof& proof, std::optional<Vector3>& far) const
{
  Covering covering = this->InitialCovering(original);
  if (this->IsUnchanged(covering))
  {
    return covering;
  }
  return this->ProofOfOriginals.Prove(original, proof, far);
}

//------------------------------------------------------------------------------
/// The last edit of the face nearest to the far point, or else LastEditAt().
Index BulkProof::EditToUndo(const Failure& failure, const std::vector<Index>& current) const
{
  Index edit = None;
  if (failure.FarPosition)
  {
    const VertexId corner = this->Bound.OriginalMesh.Corners(failure.Triangle)[0];
    const VertexWalk walk(this->Mesh);
    edit = this->Journal.LastEditOf(walk.FindNear(*failure.FarPosition, current[corner]).Face);
  }
  return edit != None ? edit : this->LastEditAt(failure.Triangle, current);
}

//------------------------------------------------------------------------------
/// The last edit at the vertices into which its corners were merged.
Index BulkProof::LastEditAt(Index original, const std::vector<Index>& current) const
{
  Index last = None;
  const auto look = [&](Index face) { last = std::max(last, this->Journal.LastEditOf(face)); };
  for (const Index corner : this->Bound.OriginalMesh.Corners(original))
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
    const Covering covering = this->InitialCovering(original);
    std::for_each(covering.Faces.begin(), covering.Faces.begin() + covering.Count, look);
  }
  return last;
}

//------------------------------------------------------------------------------
void BulkProof::WriteCoverage()
{
  this->Bound.FaceCoverage = {}; // frees its memory first
  this->Bound.FaceCoverage = this->Coverings.ToCoverage(this->Mesh.NumberOfFaceSlots());
}
}
