// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinRegions.h"

#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <atomic>

namespace bonedecimate
{
namespace
{
/// Whether a triangle of the cleaned surface belongs to no region.
std::vector<char> UnchangedTriangles(const WholeSurface& whole, const RegionParts& parts)
{
  std::vector<char> isUnchanged(whole.Cleaned.Surface.Triangles.size(), 1);
  for (const auto& part : parts)
  {
    for (const Index t : part->Covered.Triangles)
    {
      isUnchanged[t] = 0;
    }
  }
  return isUnchanged;
}

/// Numbers the points of unchanged triangles.
void AddUnchanged(const Surface& input, const WholeSurface& whole, const RegionParts& parts,
  int threads, JoinedRegions& joined)
{
  const std::vector<Triangle>& triangles = whole.Cleaned.Surface.Triangles;
  const std::vector<char> isUnchanged = UnchangedTriangles(whole, parts);
  std::vector<Index>& number = joined.OutputPoint;
  number.assign(whole.Cleaned.Surface.Points.size(), None);
  joined.UnchangedTriangle.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (isUnchanged[t] != 0)
    {
      const Triangle& c = triangles[t];
      number[c[0]] = number[c[1]] = number[c[2]] = 0;
      joined.UnchangedTriangle.push_back(static_cast<Index>(t));
    }
  }
  joined.UnchangedPoint.reserve(number.size());
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (number[p] != None)
    {
      number[p] = static_cast<Index>(joined.UnchangedPoint.size());
      joined.UnchangedPoint.push_back(static_cast<Index>(p));
    }
  }
  Surface& surface = joined.Surface;
  surface.Points.resize(joined.UnchangedPoint.size());
  ForEachId(surface.Points.size(), threads,
    [&](std::size_t p)
    { surface.Points[p] = input.Points[whole.Cleaned.InputPoint[joined.UnchangedPoint[p]]]; });
  surface.Triangles.resize(joined.UnchangedTriangle.size());
  ForEachId(surface.Triangles.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = triangles[joined.UnchangedTriangle[t]];
      surface.Triangles[t] = { number[c[0]], number[c[1]], number[c[2]] };
    });
}

void AddPart(const RegionPart& part, JoinedRegions& joined)
{
  const Surface& result = part.Result.Surface;
  Surface& surface = joined.Surface;
  std::vector<Index> number(result.Points.size(), None);
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (part.OldPoint[p] != None)
    {
      number[p] = joined.OutputPoint[part.Points[part.OldPoint[p]]];
    }
    else
    {
      number[p] = static_cast<Index>(surface.Points.size());
      surface.Points.push_back(result.Points[p]);
    }
  }
  for (std::size_t t = 0; t < result.Triangles.size(); ++t)
  {
    if (part.OldTriangle[t] == None)
    {
      const Triangle& c = result.Triangles[t];
      surface.Triangles.push_back({ number[c[0]], number[c[1]], number[c[2]] });
    }
  }
  joined.PointOfPart.push_back(std::move(number));
}

/// Into what each point of the region was merged.
void MapPoints(const RegionPart& part, const std::vector<Index>& number, JoinedRegions& joined)
{
  std::size_t next = 0;
  for (std::size_t p = 0; p < part.Points.size() && next < part.Covered.Points.size(); ++p)
  {
    if (part.Points[p] == part.Covered.Points[next])
    {
      ++next;
      const Index output = part.Result.Origins.OutputPoint[p];
      joined.OutputPoint[part.Points[p]] = output == None ? None : number[output];
    }
  }
}
}

JoinedRegions JoinRegions(
  const Surface& input, const WholeSurface& whole, const RegionParts& parts, int threads)
{
  JoinedRegions joined;
  AddUnchanged(input, whole, parts, threads, joined);
  for (const auto& part : parts)
  {
    AddPart(*part, joined);
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    MapPoints(*parts[i], joined.PointOfPart[i], joined);
  }
  return joined;
}

namespace
{
bool HaveSameCorners(
  const Surface& a, std::size_t triangleOfA, const Surface& b, std::size_t triangleOfB)
{
  const Triangle& c = a.Triangles[triangleOfA];
  const Triangle& d = b.Triangles[triangleOfB];
  return a.Points[c[0]] == b.Points[d[0]] && a.Points[c[1]] == b.Points[d[1]] &&
    a.Points[c[2]] == b.Points[d[2]];
}

/// Whether no corner is out of range.
bool IsComplete(const Surface& surface)
{
  const auto points = static_cast<std::uint32_t>(surface.Points.size());
  return std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
    [=](const Triangle& c)
    {
      return std::all_of(c.begin(), c.end(),
        [=](Index point) { return static_cast<std::uint32_t>(point) < points; });
    });
}

/// Marks the triangles of the input that the part has; false if one of them is another one there,
/// or if one of the result is neither new nor unchanged.
bool CheckPart(const Surface& input, const WholeSurface& whole, const RegionPart& part,
  const std::vector<char>& isUnchanged, std::vector<char>& isCovered)
{
  const std::vector<Index>& ids = whole.Cleaned.InputTriangle;
  for (std::size_t t = 0; t < part.Triangles.size(); ++t)
  {
    const auto id = static_cast<std::size_t>(ids[part.Triangles[t]]);
    isCovered[id] = 1;
    if (!HaveSameCorners(input, id, part.Surface, t))
    {
      return false;
    }
  }
  for (std::size_t t = 0; t < part.OldTriangle.size(); ++t)
  {
    if (part.OldTriangle[t] != None)
    {
      const auto id = static_cast<std::size_t>(ids[part.Triangles[part.OldTriangle[t]]]);
      if (isUnchanged[id] == 0 || !HaveSameCorners(input, id, part.Result.Surface, t))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether the triangles from there on are the new ones of the part.
/// @param next Moved behind them.
bool AreNewTriangles(const RegionPart& part, const Surface& surface, std::size_t& next)
{
  for (std::size_t t = 0; t < part.OldTriangle.size(); ++t)
  {
    if (part.OldTriangle[t] != None)
    {
      continue;
    }
    const std::size_t at = next++;
    if (at >= surface.Triangles.size() || !HaveSameCorners(part.Result.Surface, t, surface, at))
    {
      return false;
    }
  }
  return true;
}
}

bool CheckJoined(const Surface& input, const WholeSurface& whole, const RegionParts& parts,
  const JoinedRegions& joined, int threads)
{
  const std::vector<Index>& ids = whole.Cleaned.InputTriangle;
  std::vector<char> isUnchanged(input.Triangles.size(), 0);
  std::atomic<bool> isGood{ IsComplete(joined.Surface) &&
    joined.UnchangedTriangle.size() <= joined.Surface.Triangles.size() };
  ForEachId(isGood ? joined.UnchangedTriangle.size() : 0, threads,
    [&](std::size_t t)
    {
      const auto id = static_cast<std::size_t>(ids[joined.UnchangedTriangle[t]]);
      isUnchanged[id] = 1;
      if (!HaveSameCorners(input, id, joined.Surface, t))
      {
        isGood = false;
      }
    });
  std::vector<char> isCovered = isUnchanged;
  std::size_t next = joined.UnchangedTriangle.size();
  for (std::size_t i = 0; i < parts.size() && isGood; ++i)
  {
    isGood = CheckPart(input, whole, *parts[i], isUnchanged, isCovered) &&
      AreNewTriangles(*parts[i], joined.Surface, next);
  }
  return isGood && next == joined.Surface.Triangles.size() &&
    std::all_of(ids.begin(), ids.end(),
      [&](Index id) { return isCovered[static_cast<std::size_t>(id)] != 0; });
}

//------------------------------------------------------------------------------
std::map<Index, ExtentChange> ChangesOfComponents(
  const WholeSurface& whole, const RegionParts& parts)
{
  const Surface& clean = whole.Cleaned.Surface;
  std::map<Index, ExtentChange> changes;
  const auto add = [&](Index component, const std::array<Vector3, 3>& p, double sign)
  {
    const Vector3 area = AreaVector(p[0], p[1], p[2]);
    ExtentChange& change = changes[component];
    change.Area += sign * area.norm();
    change.Volume += sign * Dot(area, p[0]) / 3.0;
  };
  for (const auto& part : parts)
  {
    std::vector<Index> componentOfPoint(part->Result.Surface.Points.size(), None);
    for (std::size_t t = 0; t < part->Triangles.size(); ++t)
    {
      for (const Index point : part->Surface.Triangles[t])
      {
        const Index output = part->Result.Origins.OutputPoint[point];
        if (output != None)
        {
          componentOfPoint[output] = whole.Components.OfTriangle[part->Triangles[t]][0];
        }
      }
    }
    for (const Index t : part->Covered.Triangles)
    {
      const Triangle& c = clean.Triangles[t];
      add(whole.Components.OfTriangle[t][0],
        { clean.Points[c[0]], clean.Points[c[1]], clean.Points[c[2]] }, -1.0);
    }
    const std::vector<Vector3>& points = part->Result.Surface.Points;
    const Vector3& origin = whole.Cleaned.Origin;
    for (std::size_t t = 0; t < part->OldTriangle.size(); ++t)
    {
      if (part->OldTriangle[t] == None)
      {
        const Triangle& c = part->Result.Surface.Triangles[t];
        add(componentOfPoint[c[0]],
          { points[c[0]] - origin, points[c[1]] - origin, points[c[2]] - origin }, 1.0);
      }
    }
  }
  return changes;
}
}
