// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ManifoldPatches.h"

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
    this->IsCollected.assign(
      static_cast<std::size_t>(HalfEdgeMesh::HalfEdge(this->Mesh.NumberOfFaceSlots(), 0)), false);
    std::vector<Index>& originals = this->Clean.ManifoldPatches.OriginalVertices;
    originals.resize(this->Clean.Surface.Points.size());
    std::iota(originals.begin(), originals.end(), 0);
    this->Clean.ManifoldPatches.Edges = this->Mesh.EdgesAtFirst();
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Split(this->Points[i], this->Corners.begin() + this->Starts[i],
        this->Corners.begin() + this->Starts[i + 1]);
    }
    return true;
  }

private:
  /// Lists the NonManifold points.
  void FindPoints()
  {
    this->Indices.assign(this->Clean.Surface.Points.size(), None);
    for (VertexId v = 0; v < this->Mesh.NumberOfVertexSlots(); ++v)
    {
      if (this->Mesh.Constraint(v) == VertexConstraint::NonManifold)
      {
        this->Indices[v] = static_cast<Index>(this->Points.size());
        this->Points.push_back(v);
      }
    }
  }

  /// Lists the outgoing half-edges of each of these points.
  void GatherCorners()
  {
    this->Starts.assign(this->Points.size() + 1, 0);
    const auto visitCorners = [this](const auto& visit)
    {
      for (FaceId face = 0; face < this->Mesh.NumberOfFaceSlots(); ++face)
      {
        for (Index k = 0; k < 3; ++k)
        {
          const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
          const Index index = this->Indices[this->Mesh.Origin(h)];
          if (index != None)
          {
            visit(h, index);
          }
        }
      }
    };
    visitCorners([this](Index, Index index) { ++this->Starts[index + 1]; });
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Corners.resize(static_cast<std::size_t>(this->Starts.back()));
    std::vector<Index> next(this->Starts.begin(), this->Starts.end() - 1);
    visitCorners([&](HalfEdgeId h, Index index) { this->Corners[next[index]++] = h; });
  }

  using Iterator = std::vector<Index>::iterator;

  /// Duplicates the point for each fan but the first.
  void Split(Index point, Iterator first, Iterator last)
  {
    bool isFirst = true;
    for (; first != last; ++first)
    {
      if (!this->IsCollected[*first])
      {
        this->NameFan(*first, isFirst ? point : this->AddCopy(point));
        isFirst = false;
      }
    }
  }

  /// Collects a fan from one corner in both directions around the point.
  void NameFan(Index corner, Index name)
  {
    const auto isNew = [this](HalfEdgeId h) { return h != None && !this->IsCollected[h]; };
    const auto give = [this, name](HalfEdgeId h)
    {
      this->IsCollected[h] = true;
      this->Clean.Surface.Triangles[h >> 2][h & 3] = name;
    };
    const auto before = [this](HalfEdgeId h) { return this->Mesh.Twin(HalfEdgeMesh::Previous(h)); };
    const auto after = [this](HalfEdgeId h)
    {
      const HalfEdgeId twin = this->Mesh.Twin(h);
      return twin == None ? HalfEdgeId() : HalfEdgeMesh::Next(twin);
    };
    give(corner);
    for (HalfEdgeId h = before(corner); isNew(h); h = before(h))
    {
      give(h);
    }
    for (HalfEdgeId h = after(corner); isNew(h); h = after(h))
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
    this->Clean.ManifoldPatches.OriginalVertices.push_back(point);
    return copy;
  }

  CleanSurface& Clean;
  const HalfEdgeMesh& Mesh;
  std::vector<Index> Indices; // for each point its index in Points; None: it is not split
  std::vector<Index> Points;
  std::vector<Index> Starts; // for each of Points its first corner
  std::vector<Index> Corners;
  std::vector<bool> IsCollected; // for each half-edge, whether its fan has been collected
};
}

bool SplitIntoManifoldPatches(CleanSurface& clean, const HalfEdgeMesh& mesh)
{
  return Splitter(clean, mesh).Run();
}

//------------------------------------------------------------------------------
std::int64_t NumberOfOriginalVertices(const CleanSurface& clean)
{
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  std::int64_t copies = 0;
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    copies += originals[v] != static_cast<Index>(v) ? 1 : 0;
  }
  return static_cast<std::int64_t>(clean.Surface.Points.size()) - copies;
}
}
