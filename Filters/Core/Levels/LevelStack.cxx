// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelStack.h"

#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace bonedecimate
{
/// Replays the log. Validates every value before it is used.
class LevelStack::Builder
{
public:
  Builder(const std::vector<Triangle>& triangles, const EditLog& log, LevelStack& made)
    : Log(log)
    , Made(made)
    , Current(static_cast<std::size_t>(log.Vertices))
    , Left(static_cast<Index>(triangles.size()))
  {
    made.Corners = triangles;
    made.FaceEnds.assign(triangles.size(), Never);
    made.LastChange.assign(triangles.size(), None);
    made.Lives.assign(this->Current.size(), Life());
    made.Placings.reserve(log.Collapses.size());
    made.FacesLeft.reserve(log.Collapses.size() + 1);
    for (std::size_t v = 0; v < this->Current.size(); ++v)
    {
      this->Current[v] = static_cast<Index>(v);
    }
  }

  bool Replay()
  {
    auto patch = this->Log.Patches.begin();
    const auto patchesOf = [&](Index time)
    {
      bool good = true;
      for (; good && patch != this->Log.Patches.end() && patch->Collapses == time; ++patch)
      {
        good = this->Apply(*patch, time);
      }
      return good;
    };
    bool good = patchesOf(0);
    this->Made.FacesLeft.push_back(this->Left);
    Index time = 0;
    for (const LoggedCollapse& collapse : this->Log.Collapses)
    {
      ++time;
      good = good && this->Apply(collapse, time) && patchesOf(time);
      this->Made.FacesLeft.push_back(this->Left);
    }
    return good && patch == this->Log.Patches.end();
  }

  /// Sorts the positions by vertex.
  void SortPlacings()
  {
    std::vector<Index>& first = this->Made.FirstPlacing;
    first.assign(this->Current.size() + 1, 0);
    for (const Placing& placing : this->Made.Placings)
    {
      ++first[static_cast<std::size_t>(placing.Vertex) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> next(first.begin(), first.end() - 1);
    std::vector<Placing> sorted(this->Made.Placings.size());
    for (const Placing& placing : this->Made.Placings)
    {
      sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(placing.Vertex)]++)] = placing;
    }
    this->Made.Placings = std::move(sorted);
  }

private:
  bool IsLiveFace(Index face) const
  {
    return face >= 0 && face < static_cast<Index>(this->Made.FaceEnds.size()) &&
      this->Made.FaceEnds[static_cast<std::size_t>(face)] == Never;
  }
  bool IsLiveVertex(Index v) const
  {
    return v >= 0 && v < static_cast<Index>(this->Current.size()) &&
      this->Made.Lives[static_cast<std::size_t>(v)].End == Never;
  }

  /// The vertex into which the vertex was merged, with path halving.
  Index Now(Index v)
  {
    while (this->Current[static_cast<std::size_t>(v)] != v)
    {
      Index& next = this->Current[static_cast<std::size_t>(v)];
      next = this->Current[static_cast<std::size_t>(next)];
      v = next;
    }
    return v;
  }

  Triangle CornersNow(Index face)
  {
    const Index change = this->Made.LastChange[static_cast<std::size_t>(face)];
    const Triangle& c = change == None
      ? this->Made.Corners[static_cast<std::size_t>(face)]
      : this->Made.Changes[static_cast<std::size_t>(change)].Corners;
    return { this->Now(c[0]), this->Now(c[1]), this->Now(c[2]) };
  }

  bool Apply(const LoggedCollapse& collapse, Index time)
  {
    const Index face = HalfEdgeMesh::Face(collapse.HalfEdge);
    const auto corner = static_cast<std::size_t>(collapse.HalfEdge & 3);
    if (collapse.HalfEdge < 0 || corner > 2 || !this->IsLiveFace(face))
    {
      return false;
    }
    const Triangle corners = this->CornersNow(face);
    const Index start = corners[corner];
    const Index end = corners[(corner + 1) % 3];
    const Index gone = collapse.Kept == start ? end : start;
    if (start == end || (collapse.Kept != start && collapse.Kept != end) ||
      !IsUsable(collapse.Position) || !this->Remove(collapse.OtherFace, face, { start, end }, time))
    {
      return false;
    }
    this->Made.FaceEnds[static_cast<std::size_t>(face)] = time;
    --this->Left;
    this->Made.Lives[static_cast<std::size_t>(gone)] = { time, collapse.Kept };
    this->Current[static_cast<std::size_t>(gone)] = collapse.Kept;
    this->SetPosition(collapse.Kept, collapse.Position, time);
    return true;
  }

  /// The face on the other side of the edge.
  bool Remove(Index other, Index first, const std::array<Index, 2>& edge, Index time)
  {
    if (other == None)
    {
      return true;
    }
    if (other == first || !this->IsLiveFace(other))
    {
      return false;
    }
    const Triangle across = this->CornersNow(other);
    this->Made.FaceEnds[static_cast<std::size_t>(other)] = time;
    --this->Left;
    return std::all_of(edge.begin(), edge.end(),
      [&](Index v) { return std::find(across.begin(), across.end(), v) != across.end(); });
  }

  bool Apply(const LoggedPatch& patch, Index time)
  {
    for (const LoggedPatch::Face& face : patch.Faces)
    {
      const Triangle& c = face.Corners;
      if (!this->IsLiveFace(face.Id) ||
        !std::all_of(c.begin(), c.end(), [this](Index v) { return this->IsLiveVertex(v); }) ||
        c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      {
        return false;
      }
      Index& last = this->Made.LastChange[static_cast<std::size_t>(face.Id)];
      this->Made.Changes.push_back({ c, time, last });
      last = static_cast<Index>(this->Made.Changes.size()) - 1;
    }
    for (const LoggedPatch::Vertex& vertex : patch.Vertices)
    {
      if (!this->IsLiveVertex(vertex.Id) || !IsUsable(vertex.Position))
      {
        return false;
      }
      this->SetPosition(vertex.Id, vertex.Position, time);
    }
    return true;
  }

  void SetPosition(Index vertex, const Vector3& position, Index time)
  {
    this->Made.Placings.push_back({ position, time, vertex });
  }

  const EditLog& Log;
  LevelStack& Made;
  std::vector<Index> Current; // for each vertex: itself or a vertex into which it was merged
  Index Left;                 // faces
};

std::optional<LevelStack> LevelStack::Build(
  const std::vector<Triangle>& triangles, const EditLog& log)
{
  const auto isVertex = [&](const Triangle& c)
  { return std::all_of(c.begin(), c.end(), [&](Index v) { return v >= 0 && v < log.Vertices; }); };
  std::optional<LevelStack> stack;
  if (static_cast<std::size_t>(log.Faces) == triangles.size() &&
    std::all_of(triangles.begin(), triangles.end(), isVertex))
  {
    stack.emplace();
    Builder builder(triangles, log, *stack);
    if (!builder.Replay())
    {
      return {};
    }
    builder.SortPlacings();
  }
  return stack;
}

//------------------------------------------------------------------------------
Index LevelStack::LevelOf(Index triangles) const
{
  const auto found = std::lower_bound(
    this->FacesLeft.begin(), this->FacesLeft.end(), triangles, std::greater<Index>());
  return std::min(static_cast<Index>(found - this->FacesLeft.begin()), this->NumberOfCollapses());
}

//------------------------------------------------------------------------------
std::vector<Index> LevelStack::FacesAt(Index collapses) const
{
  std::vector<Index> faces;
  faces.reserve(static_cast<std::size_t>(this->TrianglesAt(collapses)));
  for (std::size_t face = 0; face < this->FaceEnds.size(); ++face)
  {
    if (this->FaceEnds[face] > collapses)
    {
      faces.push_back(static_cast<Index>(face));
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
Triangle LevelStack::CornersAt(Index face, Index time) const
{
  Index change = this->LastChange[static_cast<std::size_t>(face)];
  while (change != None && this->Changes[static_cast<std::size_t>(change)].Time > time)
  {
    change = this->Changes[static_cast<std::size_t>(change)].Before;
  }
  const Triangle& c = change == None ? this->Corners[static_cast<std::size_t>(face)]
                                     : this->Changes[static_cast<std::size_t>(change)].Corners;
  return { this->VertexAt(c[0], time), this->VertexAt(c[1], time), this->VertexAt(c[2], time) };
}

//------------------------------------------------------------------------------
const Vector3* LevelStack::PositionAt(Index vertex, Index time) const
{
  const auto v = static_cast<std::size_t>(vertex);
  const Placing* first = this->Placings.data() + this->FirstPlacing[v];
  const Placing* last = this->Placings.data() + this->FirstPlacing[v + 1];
  while (last != first && (last - 1)->Time > time)
  {
    --last;
  }
  return last == first ? nullptr : &(last - 1)->Position;
}

//------------------------------------------------------------------------------
Level LevelStack::At(Index collapses, int threads, const std::vector<Vector3>& points,
  const std::vector<Index>& originals) const
{
  const auto joined = [&originals](const Triangle& c) {
    return originals.empty() ? c : Triangle{ originals[c[0]], originals[c[1]], originals[c[2]] };
  };
  Level level;
  level.Surface.Triangles = LiveTriangles(
    this->FaceEnds.size(), threads,
    [&](std::size_t face) { return this->FaceEnds[face] > collapses; },
    [&](std::size_t face) { return joined(this->CornersAt(static_cast<Index>(face), collapses)); });
  level.Vertices = NumberVertices(this->Lives.size(), level.Surface.Triangles, threads);
  level.Surface.Points.resize(level.Vertices.size());
  ForEachId(level.Vertices.size(), threads,
    [&](std::size_t p)
    {
      const Index vertex = level.Vertices[p];
      const Vector3* position = this->PositionAt(vertex, collapses);
      level.Surface.Points[p] =
        position != nullptr ? *position : points[static_cast<std::size_t>(vertex)];
    });
  return level;
}
}
