// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
namespace
{
class Splitter
{
public:
  Splitter(CleanSurface& clean, const HalfEdgeMesh& mesh)
    : Clean(clean)
    , Mesh(mesh)
  {
  }

  bool Run()
  {
    this->FindPoints();
    if (this->Points.empty())
    {
      return false;
    }
    this->GatherCorners();
    this->IsNamed.assign(
      static_cast<std::size_t>(HalfEdgeMesh::HalfEdge(this->Mesh.NumberOfFaceSlots(), 0)), false);
    std::vector<Index>& sites = this->Clean.Sheets.Sites;
    sites.resize(this->Clean.Surface.Points.size());
    std::iota(sites.begin(), sites.end(), 0);
    this->Clean.Sheets.Edges = this->Mesh.EdgesAtFirst();
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Split(this->Points[i], this->Corners.begin() + this->Starts[i],
        this->Corners.begin() + this->Starts[i + 1]);
    }
    return true;
  }

private:
  /// The locked ones.
  void FindPoints()
  {
    this->Places.assign(this->Clean.Surface.Points.size(), None);
    for (Index v = 0; v < this->Mesh.NumberOfVertexSlots(); ++v)
    {
      if (this->Mesh.Kind(v) == VertexKind::Locked)
      {
        this->Places[v] = static_cast<Index>(this->Points.size());
        this->Points.push_back(v);
      }
    }
  }

  /// Of each of those points the half-edges that leave it.
  void GatherCorners()
  {
    this->Starts.assign(this->Points.size() + 1, 0);
    const auto visitCorners = [this](const auto& visit)
    {
      for (Index face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
      {
        for (Index k = 0; k < 3; ++k)
        {
          const Index h = HalfEdgeMesh::HalfEdge(face, k);
          const Index place = this->Places[this->Mesh.Origin(h)];
          if (place != None)
          {
            visit(h, place);
          }
        }
      }
    };
    visitCorners([this](Index, Index place) { ++this->Starts[place + 1]; });
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Corners.resize(static_cast<std::size_t>(this->Starts.back()));
    std::vector<Index> next(this->Starts.begin(), this->Starts.end() - 1);
    visitCorners([&](Index h, Index place) { this->Corners[next[place]++] = h; });
  }

  using Iterator = std::vector<Index>::iterator;

  /// The first fan keeps the point.
  void Split(Index point, Iterator first, Iterator last)
  {
    bool isFirst = true;
    for (; first != last; ++first)
    {
      if (!this->IsNamed[*first])
      {
        this->NameFan(*first, isFirst ? point : this->AddCopy(point));
        isFirst = false;
      }
    }
  }

  /// From one corner of the fan both ways round the point.
  void NameFan(Index corner, Index name)
  {
    const auto isNew = [this](Index h) { return h != None && !this->IsNamed[h]; };
    const auto give = [this, name](Index h)
    {
      this->IsNamed[h] = true;
      this->Clean.Surface.Triangles[h >> 2][h & 3] = name;
    };
    const auto before = [this](Index h) { return this->Mesh.Twin(HalfEdgeMesh::Previous(h)); };
    const auto after = [this](Index h)
    {
      const Index twin = this->Mesh.Twin(h);
      return twin == None ? None : HalfEdgeMesh::Next(twin);
    };
    give(corner);
    for (Index h = before(corner); isNew(h); h = before(h))
    {
      give(h);
    }
    for (Index h = after(corner); isNew(h); h = after(h))
    {
      give(h);
    }
  }

  Index AddCopy(Index point)
  {
    const Index copy = static_cast<Index>(this->Clean.Surface.Points.size());
    this->Clean.Surface.Points.push_back(Vector3(this->Clean.Surface.Points[point]));
    this->Clean.InputPoint.push_back(Index(this->Clean.InputPoint[point]));
    this->Clean.InputPointCount.push_back(0);
    this->Clean.Sheets.Sites.push_back(point);
    return copy;
  }

  CleanSurface& Clean;
  const HalfEdgeMesh& Mesh;
  std::vector<Index> Places; // of each point, in the next list; None: it stays as it is
  std::vector<Index> Points;
  std::vector<Index> Starts; // of each of those points, in the next list
  std::vector<Index> Corners;
  std::vector<bool> IsNamed; // of each half-edge, whether the fan of its origin has its point
};
}

bool SplitSheets(CleanSurface& clean, const HalfEdgeMesh& mesh)
{
  return Splitter(clean, mesh).Run();
}

//------------------------------------------------------------------------------
std::int64_t NumberOfSites(const CleanSurface& clean)
{
  const std::vector<Index>& sites = clean.Sheets.Sites;
  std::int64_t copies = 0;
  for (std::size_t v = 0; v < sites.size(); ++v)
  {
    copies += sites[v] != static_cast<Index>(v) ? 1 : 0;
  }
  return static_cast<std::int64_t>(clean.Surface.Points.size()) - copies;
}
}
