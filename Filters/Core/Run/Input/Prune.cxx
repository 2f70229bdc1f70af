// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prune.h"

#include "ComponentCensus.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Keeps the triangles of the remaining components, renumbers their points in the same order, and
/// moves the origin to the least corner of their bounding box.
class Remover
{
public:
  Remover(const Surface& input, CleanSurface& cleaned)
    : Input(input)
    , Clean(cleaned)
    , Number(cleaned.Surface.Points.size(), None)
  {
  }

  template <typename IsGone>
  void Run(const IsGone& isGone)
  {
    this->KeepTriangles(isGone);
    this->KeepPoints();
    for (Triangle& corners : this->Clean.Surface.Triangles)
    {
      corners = { this->Number[corners[0]], this->Number[corners[1]], this->Number[corners[2]] };
    }
    for (Index& point : this->Clean.PointOfInput)
    {
      point = point == None ? None : this->Number[point];
    }
    this->MoveOrigin();
  }

private:
  template <typename IsGone>
  void KeepTriangles(const IsGone& isGone)
  {
    std::vector<Triangle>& triangles = this->Clean.Surface.Triangles;
    std::vector<Index>& ids = this->Clean.InputTriangle;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      if (!isGone(t)) // reads no triangle before t
      {
        for (const Index corner : triangles[t])
        {
          this->Number[corner] = 0;
        }
        triangles[kept] = triangles[t];
        ids[kept++] = ids[t];
      }
    }
    triangles.resize(kept);
    ids.resize(kept);
  }

  void KeepPoints()
  {
    Index kept = 0;
    for (std::size_t p = 0; p < this->Number.size(); ++p)
    {
      if (this->Number[p] != None)
      {
        this->Clean.InputPoint[kept] = this->Clean.InputPoint[p];
        this->Clean.InputPointCount[kept] = this->Clean.InputPointCount[p];
        this->Number[p] = kept++;
      }
    }
    this->Clean.InputPoint.resize(static_cast<std::size_t>(kept));
    this->Clean.InputPointCount.resize(static_cast<std::size_t>(kept));
    this->Clean.Surface.Points.resize(static_cast<std::size_t>(kept));
  }

  void MoveOrigin()
  {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    for (const Index point : this->Clean.InputPoint)
    {
      low = low.cwiseMin(this->Input.Points[point]);
    }
    this->Clean.Origin = low;
    for (std::size_t p = 0; p < this->Clean.InputPoint.size(); ++p)
    {
      this->Clean.Surface.Points[p] = this->Input.Points[this->Clean.InputPoint[p]] - low;
    }
  }

  const Surface& Input;
  CleanSurface& Clean;
  std::vector<Index> Number; // for each point its new index; None if it is removed
};
}

bool IsPruned(const PrunedComponent& component, const Options& limits)
{
  return component.Triangles < limits.PruneTriangles || component.Size < limits.PruneSize ||
    component.Area < limits.PruneArea || component.Volume < limits.PruneVolume;
}

//------------------------------------------------------------------------------
PruneFigures FindPruned(const std::vector<PrunedComponent>& components, const Options& limits)
{
  PruneFigures figures;
  figures.IsRequested = limits.Prunes();
  for (const PrunedComponent& component : components)
  {
    if (IsPruned(component, limits))
    {
      figures.Triangles += component.Triangles;
      figures.Components.push_back(component);
    }
  }
  figures.TookAll = figures.Components.size() == components.size();
  std::stable_sort(figures.Components.begin(), figures.Components.end(),
    [](const PrunedComponent& a, const PrunedComponent& b) { return a.Size > b.Size; });
  return figures;
}

//------------------------------------------------------------------------------
PruneFigures Prune(const Surface& input, const Options& options, CleanSurface& cleaned)
{
  if (!options.Prunes())
  {
    return {};
  }
  const CensusOfPart census =
    TakeCensus(input, cleaned, cleaned.Origin, {}, options.NumberOfThreads);
  const std::vector<PrunedComponent> components =
    JoinCensus({ census }, cleaned.Origin).All; // in the same order
  PruneFigures figures = FindPruned(components, options);
  if (!figures.Components.empty() && !figures.TookAll)
  {
    Remover(input, cleaned)
      .Run([&](std::size_t t) { return IsPruned(components[census.OfTriangle[t]], options); });
  }
  return figures;
}
}
