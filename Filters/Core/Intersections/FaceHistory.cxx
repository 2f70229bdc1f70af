// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceHistory.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
namespace
{
constexpr std::size_t Sizes = 64; // factors of two

/// Of the longest side of a box, from fine to coarse.
std::uint8_t SizeOf(const FloatBox& box)
{
  const float side = std::max(
    { box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2], 1e-9F });
  return static_cast<std::uint8_t>(std::clamp(std::ilogb(side) + 32, 0, 63));
}
}

FaceHistory::FaceHistory(const HalfEdgeMesh& mesh, const EditJournal& journal, int threads)
  : Mesh(mesh)
  , Journal(journal)
  , Threads(threads)
  , First(journal.Count())
  , End(First)
  , AtFirst(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
{
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    this->AtFirst[face] = mesh.IsAlive(face) ? ToId(face) : None;
    this->Alive += mesh.IsAlive(face) ? 1 : 0;
  }
  this->Build(this->FindVersions());
}

//------------------------------------------------------------------------------
FaceVersion FaceHistory::Version(Id id) const
{
  const FaceId face = None - 1 - id; // where it is one
  return id > None ? this->Journal.Version(id)
                   : this->Journal.LastVersion(face, this->Mesh.Corners(face));
}

//------------------------------------------------------------------------------
void FaceHistory::GoBack(Index mostVersions, const SpaceTimeTree* region)
{
  this->Tree.reset();
  this->Ids = std::vector<Id>();
  this->End = this->First;
  for (Index versions = this->Alive; this->First > 0; --this->First)
  {
    const JournalEntry& entry = this->Journal.Entry(this->First - 1);
    versions += entry.IsUndone ? 0 : entry.NumberOfFaces;
    if (versions > mostVersions && this->First < this->End)
    {
      break;
    }
    this->Alive += entry.IsUndone ? 0 : JournalEntry::NumberOfGoneFaces;
  }
  std::vector<Timed> versions = this->FindVersions();
  if (region != nullptr)
  {
    this->KeepNear(*region, versions);
  }
  this->Build(std::move(versions));
}

//------------------------------------------------------------------------------
void FaceHistory::Find(
  const FloatBox& box, Index first, Index last, std::vector<Candidate>& found) const
{
  found.clear();
  this->Tree->VisitWhile({ box, first, last },
    [&](const TimedBox& timed, std::size_t position) {
      found.push_back({ timed, this->Ids[position] });
    });
}

//------------------------------------------------------------------------------
/// Of the window, by face.
std::vector<FaceHistory::Timed> FaceHistory::FindVersions()
{
  std::vector<Index> starts(this->AtFirst.size() + 1, 0);
  const auto visitReplaced = [this](const auto& visit)
  {
    for (Index edit = this->End; edit-- > this->First;)
    {
      const JournalEntry& entry = this->Journal.Entry(edit);
      for (Index i = 0; !entry.IsUndone && i < entry.NumberOfFaces; ++i)
      {
        visit(entry.FirstFace + i, edit);
      }
    }
  };
  for (std::size_t face = 0; face < this->AtFirst.size(); ++face)
  {
    starts[face + 1] = this->AtFirst[face] == None ? 0 : 1;
  }
  visitReplaced([&](Id id, Index) { ++starts[this->Journal.Version(id).Face + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Timed> versions(static_cast<std::size_t>(starts.back()));
  for (std::size_t face = 0; face < this->AtFirst.size(); ++face)
  {
    if (this->AtFirst[face] != None)
    {
      versions[starts[face]++] = { this->AtFirst[face], SpaceTimeTree::Never };
    }
  }
  visitReplaced(
    [&](Id id, Index edit)
    {
      const FaceId face = this->Journal.Version(id).Face;
      versions[starts[face]++] = { id, edit };
      this->AtFirst[face] = id;
    });
  return versions;
}

//------------------------------------------------------------------------------
TimedBox FaceHistory::BoxOf(const Timed& version) const
{
  const FaceVersion face = this->Version(version.Version);
  return { FloatBox(this->Journal.CornersOf(face)), face.Made, version.Replaced };
}

//------------------------------------------------------------------------------
void FaceHistory::KeepNear(const SpaceTimeTree& region, std::vector<Timed>& versions) const
{
  std::vector<char> isNear(versions.size());
  ForEachId(versions.size(), this->Threads,
    [&](std::size_t i) { isNear[i] = region.HasWhile(this->BoxOf(versions[i])) ? 1 : 0; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < versions.size(); ++i)
  {
    versions[kept] = versions[i];
    kept += isNear[i] != 0 ? 1 : 0;
  }
  versions.resize(kept);
  versions.shrink_to_fit();
}

//------------------------------------------------------------------------------
void FaceHistory::SortBySize(std::vector<Timed>& versions) const
{
  std::vector<std::uint8_t> sizes(versions.size());
  ForEachId(versions.size(), this->Threads,
    [&](std::size_t i) { sizes[i] = SizeOf(this->BoxOf(versions[i]).Box); });
  std::array<std::size_t, Sizes + 1> starts{};
  for (const std::uint8_t size : sizes)
  {
    ++starts[size + 1U];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Timed> sorted(versions.size());
  for (std::size_t i = 0; i < versions.size(); ++i)
  {
    sorted[starts[sizes[i]]++] = versions[i];
  }
  versions = std::move(sorted);
}

//------------------------------------------------------------------------------
void FaceHistory::Build(std::vector<Timed> versions)
{
  this->SortBySize(versions);
  std::vector<TimedBox> boxes(versions.size());
  this->Ids.resize(versions.size());
  ForEachId(versions.size(), this->Threads,
    [&](std::size_t i)
    {
      boxes[i] = this->BoxOf(versions[i]);
      this->Ids[i] = versions[i].Version;
    });
  versions = std::vector<Timed>();
  this->Tree.emplace(std::move(boxes), this->Threads);
}
}
