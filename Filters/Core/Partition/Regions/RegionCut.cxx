// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionCut.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Mesh/Statistics.h"
#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <iterator>

namespace bonedecimate
{
namespace
{
/// More connected pieces than this are one region: merging compares all pairs.
constexpr Index MaxRegions = 256;

/// The ids below count for which isChosen(id), ascending.
template <typename IsChosen>
std::vector<Index> IdsWhere(std::size_t count, int threads, const IsChosen& isChosen)
{
  std::vector<std::size_t> next = StartsOfBlocks(count, threads, isChosen);
  std::vector<Index> ids(next.back());
  ForEachBlock(count, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t id = first; id < last; ++id)
      {
        if (isChosen(id))
        {
          ids[next[block]++] = static_cast<Index>(id);
        }
      }
    });
  return ids;
}

bool HasCorner(const Triangle& c, const std::vector<char>& isMarked)
{
  return (isMarked[c[0]] | isMarked[c[1]] | isMarked[c[2]]) != 0;
}

void MarkCorners(
  const Surface& surface, const std::vector<Index>& triangles, std::vector<char>& isMarked)
{
  for (const Index t : triangles)
  {
    const Triangle& c = surface.Triangles[t];
    isMarked[c[0]] = isMarked[c[1]] = isMarked[c[2]] = 1;
  }
}

void Append(std::vector<Index>& all, const std::vector<Index>& more)
{
  const auto middle = static_cast<std::ptrdiff_t>(all.size());
  all.insert(all.end(), more.begin(), more.end());
  std::inplace_merge(all.begin(), all.begin() + middle, all.end());
}

void Absorb(Region& region, const Region& other)
{
  Append(region.Triangles, other.Triangles);
  Append(region.Points, other.Points);
  region.Bound.Add(other.Bound);
}

void MergeNear(std::vector<Region>& regions, double reach)
{
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      for (std::size_t j = regions.size(); j-- > i + 1;)
      {
        if (regions[i].Bound.MayBeNear(regions[j].Bound, reach))
        {
          Absorb(regions[i], regions[j]);
          regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(j));
          isChanged = true;
        }
      }
    }
  }
}

/// Merges those with points that are neighbors: the surroundings of one would have triangles of the
/// other.
void MergeNeighbors(const Surface& clean, std::vector<Region>& regions)
{
  std::vector<Index> regionOf(clean.Points.size(), None);
  DisjointSets<Index> merged(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    for (const Index point : regions[i].Points)
    {
      regionOf[point] = static_cast<Index>(i);
    }
  }
  for (const Triangle& c : clean.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index a = regionOf[c[i]];
      const Index b = regionOf[c[(i + 1) % 3]];
      if (a != None && b != None)
      {
        merged.Join(a, b);
      }
    }
  }
  for (std::size_t i = regions.size(); i-- > 0;)
  {
    const Index first = merged.Root(static_cast<Index>(i));
    if (first != static_cast<Index>(i))
    {
      Absorb(regions[first], regions[i]);
      regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

/// Connected pieces of these triangles.
std::vector<Region> PiecesOf(const Surface& clean, const std::vector<Index>& triangles, int threads)
{
  Surface changeable;
  changeable.Triangles.reserve(triangles.size());
  for (const Index t : triangles)
  {
    changeable.Triangles.push_back(clean.Triangles[t]);
  }
  const std::vector<Index> points =
    NumberVertices(clean.Points.size(), changeable.Triangles, threads);
  changeable.Points.resize(points.size());
  Components pieces = FindComponents(changeable);
  if (pieces.Count > MaxRegions)
  {
    pieces.Count = 1;
    std::fill(pieces.OfPoint.begin(), pieces.OfPoint.end(), 0);
  }
  std::vector<Region> regions(static_cast<std::size_t>(pieces.Count));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Region& region = regions[static_cast<std::size_t>(pieces.OfPoint[i])];
    region.Bound.Add(clean.Points[points[i]]);
    region.Points.push_back(points[i]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Index piece = pieces.OfPoint[changeable.Triangles[i][0]];
    regions[static_cast<std::size_t>(piece)].Triangles.push_back(triangles[i]);
  }
  return regions;
}

/// The triangles of the part.
std::vector<Index> SelectTriangles(const Surface& clean, const Region& region, int threads)
{
  const std::vector<Triangle>& all = clean.Triangles;
  std::vector<char> isNear(clean.Points.size(), 0); // corners of the region, then of the first ring
  MarkCorners(clean, region.Triangles, isNear);
  const std::vector<Index> ring =
    IdsWhere(all.size(), threads, [&](std::size_t t) { return HasCorner(all[t], isNear); });
  MarkCorners(clean, ring, isNear);
  std::vector<char> isSelected(all.size());
  ForEachId(all.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = all[t];
      isSelected[t] = HasCorner(c, isNear) ||
          region.Bound.MayBeNear(
            { clean.Points[c[0]], clean.Points[c[1]], clean.Points[c[2]] }, region.Reach)
        ? 1
        : 0;
    });
  return IdsWhere(all.size(), threads, [&](std::size_t t) { return isSelected[t] != 0; });
}
}

std::vector<Region> FindRegions(
  const Surface& clean, const std::vector<double>& tolerances, double reach, int threads)
{
  const std::vector<Index> changeable = IdsWhere(clean.Triangles.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = clean.Triangles[t];
      return tolerances[c[0]] != 0.0 && tolerances[c[1]] != 0.0 && tolerances[c[2]] != 0.0;
    });
  std::vector<Region> regions = PiecesOf(clean, changeable, threads);
  MergeNeighbors(clean, regions);
  MergeNear(regions, reach);
  for (Region& region : regions)
  {
    region.Reach = reach;
    for (const Index point : region.Points)
    {
      region.Tolerances.push_back(tolerances[point]);
    }
  }
  return regions;
}

//------------------------------------------------------------------------------
RegionPart CutRegion(
  const Surface& input, const CleanSurface& clean, const Region& region, int threads)
{
  RegionPart part;
  part.Covered = region;
  part.Triangles = SelectTriangles(clean.Surface, region, threads);
  std::vector<Triangle>& triangles = part.Surface.Triangles;
  triangles.reserve(part.Triangles.size());
  for (const Index t : part.Triangles)
  {
    triangles.push_back(clean.Surface.Triangles[t]);
  }
  part.Points = NumberVertices(clean.Surface.Points.size(), triangles, threads);
  part.Surface.Points.reserve(part.Points.size());
  std::size_t next = 0;
  for (const Index point : part.Points)
  {
    part.Surface.Points.push_back(input.Points[clean.InputPoint[point]]);
    const bool isCovered = next < region.Points.size() && region.Points[next] == point;
    part.Tolerances.push_back(isCovered ? region.Tolerances[next] : 0.0);
    next += isCovered ? 1 : 0;
  }
  return part;
}
}
