// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditJournal.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace bonedecimate
{
EditJournal::EditJournal(const HalfEdgeMesh& mesh)
  : InitialPositions(static_cast<std::size_t>(mesh.NumberOfVertexSlots()))
  , HadInitialNormals(static_cast<std::size_t>(mesh.NumberOfFaceSlots()))
  , LastEdits(HadInitialNormals.size(), None)
  , LastMerges(InitialPositions.size(), None)
{
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    this->InitialPositions[v] = mesh.Position(v);
  }
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    this->HadInitialNormals[face] = mesh.HasInitialNormal(face);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> EditJournal::MakePending()
{
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
Decision EditJournal::Check(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  const Edit& collapse = change.Requested;
  const HalfEdgeId twin = mesh.Twin(collapse.Edge);
  JournalEntry& entry = work.Entry;
  entry = {};
  entry.Keep = collapse.Keep;
  entry.Gone = mesh.OtherEnd(collapse.Edge, collapse.Keep);
  entry.NewPosition = collapse.Position;
  entry.Outgoing = { mesh.Outgoing(entry.Keep), mesh.Outgoing(entry.Gone),
    mesh.Outgoing(mesh.Apex(collapse.Edge)), mesh.Outgoing(mesh.Apex(twin)) };
  work.Faces.clear();
  for (const HalfEdgeId side : { collapse.Edge, twin })
  {
    const FaceId face = HalfEdgeMesh::Face(side);
    for (Index k = 0; k < 3; ++k)
    {
      entry.Twins[work.Faces.size()][static_cast<std::size_t>(k)] =
        mesh.Twin(HalfEdgeMesh::HalfEdge(face, k));
    }
    work.Faces.push_back({ face, mesh.Corners(face) });
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.Faces.push_back({ face.Id, mesh.Corners(face.Id) });
  }
  entry.NumberOfFaces = static_cast<std::uint16_t>(work.Faces.size());
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void EditJournal::Commit(
  const HalfEdgeMesh&, const SurfaceChange&, EditFilter::Pending& pending, Tally& tally)
{
  const Pending& work = static_cast<const Pending&>(pending);
  tally.Journal.Entries.push_back(work.Entry);
  tally.Journal.Faces.insert(tally.Journal.Faces.end(), work.Faces.begin(), work.Faces.end());
}

//------------------------------------------------------------------------------
/// Workers that are active at the same time edit no face in common, so the edits of one worker
/// after those of another are a valid order.
void EditJournal::Settle(Tally* tallies, std::size_t count)
{
  for (Tally* tally = tallies; tally != tallies + count; ++tally)
  {
    const JournalPart::Face* faces = tally->Journal.Faces.data();
    for (const JournalEntry& entry : tally->Journal.Entries)
    {
      this->Link(entry, faces);
      faces += entry.NumberOfFaces;
    }
    tally->Journal.Entries.clear();
    tally->Journal.Faces.clear();
  }
}

//------------------------------------------------------------------------------
void EditJournal::Link(JournalEntry entry, const JournalPart::Face* faces)
{
  const Index edit = this->Count();
  entry.FirstFace = static_cast<Index>(this->Versions.Size());
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const JournalPart::Face& face = faces[i];
    this->Versions.PushBack(this->LastVersion(face.Id, face.Corners));
    this->LastEdits[face.Id] = edit;
  }
  entry.PreviousMerge = std::exchange(this->LastMerges[entry.Keep], edit);
  this->Entries.PushBack(entry);
}

//------------------------------------------------------------------------------
Index EditJournal::PositionOf(VertexId vertex) const
{
  const Index last = this->LastMerges[vertex];
  return last == None ? Index(vertex) : static_cast<Index>(this->InitialPositions.size()) + last;
}

//------------------------------------------------------------------------------
FaceVersion EditJournal::LastVersion(FaceId face, const Triangle& corners) const
{
  return { face, this->LastEdits[face],
    { this->PositionOf(corners[0]), this->PositionOf(corners[1]), this->PositionOf(corners[2]) } };
}

//------------------------------------------------------------------------------
FaceVersion EditJournal::NewFace(Index edit, Index i) const
{
  const JournalEntry& entry = this->Entries[edit];
  FaceVersion face = this->OldFace(edit, i);
  face.MadeBy = edit;
  for (Index& position : face.Positions)
  {
    const VertexId vertex = this->VertexAt(position);
    const bool isMoved = vertex == entry.Keep || vertex == entry.Gone;
    position = isMoved ? static_cast<Index>(this->InitialPositions.size()) + edit : position;
  }
  return face;
}

//------------------------------------------------------------------------------
/// The edit that made this old face of an edit; None if no edit made it.
Index EditJournal::MakerOf(Index edit, FaceId face) const
{
  Index i = 0;
  while (this->OldFace(edit, i).Face != face)
  {
    ++i;
  }
  return this->OldFace(edit, i).MadeBy;
}

//------------------------------------------------------------------------------
std::vector<Index> EditJournal::DependentsOf(Index edit) const
{
  std::vector<Index> all;
  std::vector<Index> open(1, edit);
  std::vector<Index> seen = open; // sorted
  while (!open.empty())
  {
    const Index at = open.back();
    open.pop_back();
    all.push_back(at);
    for (Index i = 0; i < this->Entries[at].NumberOfFaces; ++i)
    {
      for (Index later = this->LastEdits[this->OldFace(at, i).Face]; later > at;)
      {
        const auto position = std::lower_bound(seen.begin(), seen.end(), later);
        if (position == seen.end() || *position != later)
        {
          seen.insert(position, later);
          open.push_back(later);
        }
        later = this->MakerOf(later, this->OldFace(at, i).Face);
      }
    }
  }
  std::sort(all.begin(), all.end(), std::greater<>());
  return all;
}

//------------------------------------------------------------------------------
void EditJournal::Remove(Index edit)
{
  JournalEntry& entry = this->Entries[edit];
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceVersion& face = this->OldFace(edit, i);
    this->LastEdits[face.Face] = face.MadeBy;
  }
  this->LastMerges[entry.Keep] = entry.PreviousMerge;
  entry.IsUndone = true;
  ++this->UndoneCount;
}
}
