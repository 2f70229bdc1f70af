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
  Builder(const std::vector<Triangle>& triangles, const EditLog& log, LevelStack& stack)
    : Log(log)
    , Stack(stack)
    , MergedInto(static_cast<std::size_t>(log.Vertices))
    , FacesNow(static_cast<Index>(triangles.size()))
  {
    stack.Corners = triangles;
    stack.FaceEnds.assign(triangles.size(), Never);
    stack.LastChange.assign(triangles.size(), None);
    stack.VertexLives.assign(this->MergedInto.size(), VertexLife());
    stack.TimedPositions.reserve(log.Collapses.size());
    stack.FacesLeft.reserve(log.Collapses.size() + 1);
    for (std::size_t v = 0; v < this->MergedInto.size(); ++v)
    {
      this->MergedInto[v] = static_cast<Index>(v);
    }
  }

  bool Replay()
  {
    auto patch = this->Log.Patches.begin();
    const auto patchesOf = [&](Index time)
    {
      bool isGood = true;
      for (; isGood && patch != this->Log.Patches.end() && patch->Collapses == time; ++patch)
      {
        isGood = this->Apply(*patch, time);
      }
      return isGood;
    };
    bool isGood = patchesOf(0);
    this->Stack.FacesLeft.push_back(this->FacesNow);
    Index time = 0;
    for (const LoggedCollapse& collapse : this->Log.Collapses)
    {
      ++time;
      isGood = isGood && this->Apply(collapse, time) && patchesOf(time);
      this->Stack.FacesLeft.push_back(this->FacesNow);
    }
    return isGood && patch == this->Log.Patches.end();
  }

  /// Sorts the positions by vertex.
  void SortPositions()
  {
    std::vector<Index>& first = this->Stack.FirstPositions;
    first.assign(this->MergedInto.size() + 1, 0);
    for (const TimedPosition& position : this->Stack.TimedPositions)
    {
      ++first[static_cast<std::size_t>(position.Vertex) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Index> next(first.begin(), first.end() - 1);
    std::vector<TimedPosition> sorted(this->Stack.TimedPositions.size());
    for (const TimedPosition& position : this->Stack.TimedPositions)
    {
      sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(position.Vertex)]++)] =
        position;
    }
    this->Stack.TimedPositions = std::move(sorted);
  }

private:
  bool IsLiveFace(Index face) const
  {
    return face >= 0 && face < static_cast<Index>(this->Stack.FaceEnds.size()) &&
      this->Stack.FaceEnds[static_cast<std::size_t>(face)] == Never;
  }
  bool IsLiveVertex(Index v) const
  {
    return v >= 0 && v < static_cast<Index>(this->MergedInto.size()) &&
      this->Stack.VertexLives[static_cast<std::size_t>(v)].End == Never;
  }

  /// The vertex into which the vertex was merged, with path halving.
  Index Now(Index v)
  {
    while (this->MergedInto[static_cast<std::size_t>(v)] != v)
    {
      Index& next = this->MergedInto[static_cast<std::size_t>(v)];
      next = this->MergedInto[static_cast<std::size_t>(next)];
      v = next;
    }
    return v;
  }

  Triangle CornersNow(Index face)
  {
    const Index change = this->Stack.LastChange[static_cast<std::size_t>(face)];
    const Triangle& c = change == None
      ? this->Stack.Corners[static_cast<std::size_t>(face)]
      : this->Stack.Changes[static_cast<std::size_t>(change)].Corners;
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
    const Index gone = collapse.KeptVertex == start ? end : start;
    if (start == end || (collapse.KeptVertex != start && collapse.KeptVertex != end) ||
      !IsUsable(collapse.Position) || !this->Remove(collapse.OtherFace, face, { start, end }, time))
    {
      return false;
    }
    this->Stack.FaceEnds[static_cast<std::size_t>(face)] = time;
    --this->FacesNow;
    this->Stack.VertexLives[static_cast<std::size_t>(gone)] = { time, collapse.KeptVertex };
    this->MergedInto[static_cast<std::size_t>(gone)] = collapse.KeptVertex;
    this->SetPosition(collapse.KeptVertex, collapse.Position, time);
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
    this->Stack.FaceEnds[static_cast<std::size_t>(other)] = time;
    --this->FacesNow;
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
      Index& last = this->Stack.LastChange[static_cast<std::size_t>(face.Id)];
      this->Stack.Changes.push_back({ c, time, last });
      last = static_cast<Index>(this->Stack.Changes.size()) - 1;
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
    this->Stack.TimedPositions.push_back({ position, time, vertex });
  }

  const EditLog& Log;
  LevelStack& Stack;
  std::vector<Index> MergedInto; // of each vertex: itself or a vertex into which it was merged
  Index FacesNow;                // faces
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
    builder.SortPositions();
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
    change = this->Changes[static_cast<std::size_t>(change)].Previous;
  }
  const Triangle& c = change == None ? this->Corners[static_cast<std::size_t>(face)]
                                     : this->Changes[static_cast<std::size_t>(change)].Corners;
  return { this->VertexAt(c[0], time), this->VertexAt(c[1], time), this->VertexAt(c[2], time) };
}

//------------------------------------------------------------------------------
const Vector3* LevelStack::PositionAt(Index vertex, Index time) const
{
  const auto v = static_cast<std::size_t>(vertex);
  const TimedPosition* first = this->TimedPositions.data() + this->FirstPositions[v];
  const TimedPosition* last = this->TimedPositions.data() + this->FirstPositions[v + 1];
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
  level.Vertices = NumberVertices(this->VertexLives.size(), level.Surface.Triangles, threads);
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
