// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceHistory.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
namespace
{
constexpr std::size_t Sizes = 64; // factors of two

/// Of the longest side of a box, from fine to coarse.
std::size_t SizeOf(const FloatBox& box)
{
  const float side = std::max(
    { box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2], 1e-9F });
  return static_cast<std::size_t>(std::clamp(std::ilogb(side) + 32, 0, 63));
}

/// These arrays are most of the memory of a draft: one after the other is copied.
template <typename Entry>
void MoveTo(const std::vector<Index>& positions, std::vector<Entry>& entries)
{
  std::vector<Entry> moved(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    moved[positions[i]] = entries[i];
  }
  entries = std::move(moved);
}
}

FaceHistory::FaceHistory(const HalfEdgeMesh& mesh, const EditJournal& journal)
  : Journal(journal)
  , FirstPositions(static_cast<std::size_t>(mesh.NumberOfVertexSlots()))
  , Current(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
  , CurrentPositions(FirstPositions.size())
  , OldVersions(static_cast<std::size_t>(journal.NumberOfFaceRecords()), None)
  , NewVersions(OldVersions.size(), None)
{
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    this->FirstPositions[v] = journal.PositionBefore(v, 0);
  }
  std::iota(this->CurrentPositions.begin(), this->CurrentPositions.end(), 0);
  this->AddFirst(mesh);
  for (Index edit = 0; edit < journal.Count(); ++edit)
  {
    if (!journal.Entry(edit).IsUndone)
    {
      this->Replace(edit);
    }
  }
  this->SortBySize();
  this->Current = {};
  this->CurrentPositions = {};
}

//------------------------------------------------------------------------------
TriangleCorners FaceHistory::CornersOf(const Version& version) const
{
  const Index vertices = static_cast<Index>(this->FirstPositions.size());
  const auto at = [&](Index position) -> const Vector3&
  {
    return position < vertices ? this->FirstPositions[position]
                               : this->Journal.Entry(position - vertices).NewPosition;
  };
  return { at(version.Positions[0]), at(version.Positions[1]), at(version.Positions[2]) };
}

//------------------------------------------------------------------------------
/// Before the first edit: as the first edit of each face found it, or as it is now.
void FaceHistory::AddFirst(const HalfEdgeMesh& mesh)
{
  std::vector<Triangle> corners(this->Current.size());
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    corners[face] = mesh.Corners(face);
  }
  for (Index edit = this->Journal.Count(); edit-- > 0;)
  {
    const JournalEntry& entry = this->Journal.Entry(edit);
    for (Index i = 0; !entry.IsUndone && i < entry.NumberOfFaces; ++i)
    {
      corners[this->Journal.FaceOf(edit, i).Id] = this->Journal.FaceOf(edit, i).Corners();
    }
  }
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (corners[face][0] != None)
    {
      this->Add(face, corners[face], None);
    }
  }
}

//------------------------------------------------------------------------------
void FaceHistory::Add(FaceId face, const Triangle& vertices, Index made)
{
  this->Current[face] = static_cast<Index>(this->Versions.size());
  this->Versions.push_back({ face, vertices,
    { this->CurrentPositions[vertices[0]], this->CurrentPositions[vertices[1]],
      this->CurrentPositions[vertices[2]] },
    made });
  this->Boxes.push_back(
    { FloatBox(this->CornersOf(this->Versions.back())), made, SpaceTimeTree::Never });
}

//------------------------------------------------------------------------------
void FaceHistory::Replace(Index edit)
{
  const JournalEntry& entry = this->Journal.Entry(edit);
  this->CurrentPositions[entry.Keep] = static_cast<Index>(this->FirstPositions.size()) + edit;
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const JournalFace& face = this->Journal.FaceOf(edit, i);
    this->OldVersions[entry.FirstFace + i] = this->Current[face.Id];
    this->Boxes[this->Current[face.Id]].Replaced = edit;
    if (i >= entry.NumberOfGoneFaces)
    {
      Triangle vertices = face.Corners();
      std::replace(vertices.begin(), vertices.end(), Index(entry.Gone), Index(entry.Keep));
      this->Add(face.Id, vertices, edit);
      this->NewVersions[entry.FirstFace + i] = this->Current[face.Id];
    }
  }
}

//------------------------------------------------------------------------------
void FaceHistory::SortBySize()
{
  std::vector<Index> startOfFaces(this->Current.size() + 1, 0);
  for (const Version& version : this->Versions)
  {
    ++startOfFaces[version.Face + 1];
  }
  std::partial_sum(startOfFaces.begin(), startOfFaces.end(), startOfFaces.begin());
  std::vector<Index> byFace(this->Versions.size());
  for (std::size_t i = 0; i < this->Versions.size(); ++i)
  {
    byFace[startOfFaces[this->Versions[i].Face]++] = static_cast<Index>(i);
  }
  std::array<std::size_t, Sizes + 1> starts{};
  for (const TimedBox& box : this->Boxes)
  {
    ++starts[SizeOf(box.Box) + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Index> positions(this->Versions.size());
  for (const Index version : byFace)
  {
    positions[version] = static_cast<Index>(starts[SizeOf(this->Boxes[version].Box)]++);
  }
  byFace = {};
  MoveTo(positions, this->Versions);
  MoveTo(positions, this->Boxes);
  for (std::vector<Index>* of : { &this->OldVersions, &this->NewVersions })
  {
    std::transform(of->begin(), of->end(), of->begin(),
      [&](Index version) { return version == None ? None : positions[version]; });
  }
  this->Tree.emplace(std::move(this->Boxes));
  this->Boxes = {};
}

//------------------------------------------------------------------------------
void FaceHistory::Undo(Index edit)
{
  const JournalEntry& entry = this->Journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    this->Tree->SetReplaced(static_cast<std::size_t>(this->OldVersions[entry.FirstFace + i]), true);
    if (i >= entry.NumberOfGoneFaces)
    {
      this->Tree->SetReplaced(
        static_cast<std::size_t>(this->NewVersions[entry.FirstFace + i]), false);
    }
  }
}
}
