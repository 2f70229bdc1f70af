// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditJournal.h"

#include <algorithm>
#include <functional>

namespace bonedecimate
{
namespace
{
JournalFace Record(const HalfEdgeMesh& mesh, FaceId face)
{
  const FaceRecord& record = *mesh.RecordOfFace(HalfEdgeMesh::HalfEdge(face, 0));
  return { face, None, record.Origins, record.Twins };
}
}

EditJournal::EditJournal(const HalfEdgeMesh& mesh)
  : Mesh(mesh)
  , OfFace(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
  , OfVertex(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
{
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> EditJournal::MakePending()
{
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
Decision EditJournal::Check(
  const HalfEdgeMesh& mesh, const ProposedEdit& edit, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  const Edit& collapse = edit.Requested;
  const HalfEdgeId twin = mesh.Twin(collapse.Edge);
  JournalEntry& entry = work.Entry;
  entry = {};
  entry.Keep = collapse.Keep;
  entry.Gone = mesh.Across(collapse.Edge, collapse.Keep);
  entry.OldPosition = mesh.Position(collapse.Keep);
  entry.NewPosition = collapse.Position;
  entry.Apexes = { mesh.Origin(HalfEdgeMesh::Previous(collapse.Edge)),
    mesh.Origin(HalfEdgeMesh::Previous(twin)) };
  entry.Outgoing = { mesh.Outgoing(entry.Keep), mesh.Outgoing(entry.Gone),
    mesh.Outgoing(entry.Apexes[0]), mesh.Outgoing(entry.Apexes[1]) };
  entry.NumberOfGoneFaces = 2;
  work.Faces.assign(
    { Record(mesh, HalfEdgeMesh::Face(collapse.Edge)), Record(mesh, HalfEdgeMesh::Face(twin)) });
  for (const SurfaceChange::Face& face : edit.Change.NewFaces)
  {
    work.Faces.push_back(Record(mesh, face.Id));
  }
  entry.NumberOfFaces = static_cast<std::uint16_t>(work.Faces.size());
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void EditJournal::Commit(
  const HalfEdgeMesh&, const ProposedEdit&, EditFilter::Pending& pending, Tally& tally)
{
  const Pending& work = static_cast<const Pending&>(pending);
  tally.Journal.Entries.push_back(work.Entry);
  tally.Journal.Faces.insert(tally.Journal.Faces.end(), work.Faces.begin(), work.Faces.end());
}

//------------------------------------------------------------------------------
/// Edits of workers that were active at the same time have no face in common: one worker's after another's is a valid order.
void EditJournal::Settle(Tally* tallies, std::size_t count)
{
  for (Tally* tally = tallies; tally != tallies + count; ++tally)
  {
    const JournalFace* faces = tally->Journal.Faces.data();
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
void EditJournal::Link(JournalEntry entry, const JournalFace* faces)
{
  const Index edit = this->Count();
  entry.FirstFace = static_cast<Index>(this->Faces.size());
  entry.Before = this->OfVertex[entry.Keep];
  this->OfVertex[entry.Keep] = edit;
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    JournalFace face = faces[i];
    face.Before = this->OfFace[face.Id];
    this->OfFace[face.Id] = edit;
    this->Faces.push_back(face);
  }
  this->Entries.push_back(entry);
}

//------------------------------------------------------------------------------
Vector3 EditJournal::PositionBefore(VertexId vertex, Index edit) const
{
  Index last = this->OfVertex[vertex];
  Index later = None;
  while (last != None && last >= edit)
  {
    later = last;
    last = this->Entries[last].Before;
  }
  return last != None ? this->Entries[last].NewPosition
    : later != None   ? this->Entries[later].OldPosition
                      : this->Mesh.Position(vertex);
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
      for (Index later = this->OfFace[this->FaceOf(at, i).Id]; later > at;)
      {
        const auto position = std::lower_bound(seen.begin(), seen.end(), later);
        if (position == seen.end() || *position != later)
        {
          seen.insert(position, later);
          open.push_back(later);
        }
        const JournalEntry& entry = this->Entries[later];
        const JournalFace* faces = this->Faces.data() + entry.FirstFace;
        later = std::find_if(faces, faces + entry.NumberOfFaces,
          [&](const JournalFace& face) {
            return face.Id == this->FaceOf(at, i).Id;
          })->Before;
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
    const JournalFace& face = this->FaceOf(edit, i);
    this->OfFace[face.Id] = face.Before;
  }
  this->OfVertex[entry.Keep] = entry.Before;
  entry.IsUndone = true;
  ++this->Undone;
}
}
