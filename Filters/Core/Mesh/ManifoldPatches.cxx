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
  Splitter(CleanSurface& clean, const EdgeMatching& edges, const Rings& rings)
    : Clean(clean)
    , Edges(edges)
    , PointRings(rings)
  {
  }

  bool Run()
  {
    const std::vector<Index> points = NonManifoldPoints(this->PointRings);
    if (points.empty())
    {
      return false;
    }
    this->IsCollected.assign(this->Edges.Twins().size(), false);
    std::vector<Index>& originals = this->Clean.ManifoldPatches.OriginalVertices;
    originals.resize(this->Clean.Surface.Points.size());
    std::iota(originals.begin(), originals.end(), 0);
    this->Clean.ManifoldPatches.Edges = this->Edges.CountEdges();
    for (const Index point : points)
    {
      this->Split(point);
    }
    return true;
  }

private:
  /// Duplicates the point for each fan but the first.
  void Split(Index point)
  {
    bool isFirst = true;
    for (const Index corner : this->Edges.OutgoingAt(point))
    {
      if (!this->IsCollected[corner])
      {
        this->NameFan(corner, isFirst ? point : this->AddCopy(point));
        isFirst = false;
      }
    }
  }

  /// Collects a fan from one corner in both directions around the point.
  void NameFan(Index corner, Index name)
  {
    const auto isNew = [this](Index h) { return h >= 0 && !this->IsCollected[h]; };
    const LargeArray<Index>& twins = this->Edges.Twins();
    const auto give = [this, name](Index h)
    {
      this->IsCollected[h] = true;
      this->Clean.Surface.Triangles[h >> 2][h & 3] = name;
    };
    const auto before = [&twins](Index h) { return twins[HalfEdgeMesh::Previous(h)]; };
    const auto after = [&twins](Index h)
    { return twins[h] < 0 ? None : Index(HalfEdgeMesh::Next(twins[h])); };
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
    this->Clean.ManifoldPatches.OriginalVertices.push_back(point);
    return copy;
  }

  CleanSurface& Clean;
  const EdgeMatching& Edges;
  const Rings& PointRings;
  std::vector<bool> IsCollected; // for each half-edge, whether its fan has been collected
};
}

bool SplitIntoManifoldPatches(CleanSurface& clean, const EdgeMatching& edges, const Rings& rings)
{
  return Splitter(clean, edges, rings).Run();
}

//------------------------------------------------------------------------------
bool SplitIntoManifoldPatches(CleanSurface& clean, int threads, const std::vector<Index>& labels)
{
  EdgeMatching edges(clean.Surface.Triangles, clean.Surface.Points.size(), threads);
  edges.CutBetween(labels);
  return SplitIntoManifoldPatches(clean, edges, edges.FindRings());
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
