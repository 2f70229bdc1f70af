// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinRegions.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Values of new points, and for the unchanged ones the largest that a part has.
void FillPoints(const RegionParts& parts, const JoinedRegions& joined,
  std::vector<double> Result::*values, Result& result)
{
  std::vector<double>& to = result.*values;
  to.assign(joined.Surface.Points.size(), 0.0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::vector<double>& from = parts[i]->Result.*values;
    for (std::size_t p = 0; p < from.size(); ++p)
    {
      double& value = to[joined.PointOfPart[i][p]];
      value = std::max(value, from[p]);
    }
  }
}

void CountPoints(const CleanSurface& clean, const JoinedRegions& joined, Result& result)
{
  result.PointCount.assign(joined.Surface.Points.size(), 0);
  for (std::size_t p = 0; p < joined.OutputPoint.size(); ++p)
  {
    if (joined.OutputPoint[p] != None)
    {
      result.PointCount[joined.OutputPoint[p]] += clean.InputPointCount[p];
    }
  }
}

/// An unchanged point lies in its first unchanged triangle.
void FillUnchangedOrigins(
  const CleanSurface& clean, const JoinedRegions& joined, SurfaceOrigins& origins)
{
  for (std::size_t t = joined.UnchangedTriangle.size(); t-- > 0;)
  {
    const Triangle& c = joined.Surface.Triangles[t];
    const Index id = clean.InputTriangle[joined.UnchangedTriangle[t]];
    origins.TriangleAtCentroid[t] = id;
    for (std::size_t k = 0; k < 3; ++k)
    {
      origins.NearestTriangle[c[k]] = id;
      origins.Barycentric[c[k]] = { 0.0, 0.0, 0.0 };
      origins.Barycentric[c[k]][k] = 1.0;
    }
  }
  for (std::size_t p = 0; p < joined.UnchangedPoint.size(); ++p)
  {
    origins.NearestPoint[p] = clean.InputPoint[joined.UnchangedPoint[p]];
  }
}

/// @param nextTriangle The first new triangle of the part; moved behind its last.
void FillOriginsOfPart(const CleanSurface& clean, const RegionPart& part,
  const std::vector<Index>& number, std::size_t& nextTriangle, SurfaceOrigins& origins)
{
  const SurfaceOrigins& from = part.Result.Origins;
  const auto triangle = [&](Index t) { return clean.InputTriangle[part.Triangles[t]]; };
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (part.OldPoint[p] == None)
    {
      origins.NearestTriangle[number[p]] = triangle(from.NearestTriangle[p]);
      origins.Barycentric[number[p]] = from.Barycentric[p];
      origins.NearestPoint[number[p]] = clean.InputPoint[part.Points[from.NearestPoint[p]]];
    }
  }
  for (std::size_t t = 0; t < part.OldTriangle.size(); ++t)
  {
    if (part.OldTriangle[t] == None)
    {
      origins.TriangleAtCentroid[nextTriangle++] = triangle(from.TriangleAtCentroid[t]);
    }
  }
}

void FillOrigins(const CleanSurface& clean, const RegionParts& parts, const JoinedRegions& joined,
  SurfaceOrigins& origins)
{
  origins.NearestTriangle.resize(joined.Surface.Points.size());
  origins.Barycentric.resize(joined.Surface.Points.size());
  origins.NearestPoint.resize(joined.Surface.Points.size());
  origins.TriangleAtCentroid.resize(joined.Surface.Triangles.size());
  FillUnchangedOrigins(clean, joined, origins);
  std::size_t nextTriangle = joined.UnchangedTriangle.size();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    FillOriginsOfPart(clean, *parts[i], joined.PointOfPart[i], nextTriangle, origins);
  }
  origins.OutputPoint.reserve(clean.PointOfInput.size());
  for (const Index point : clean.PointOfInput)
  {
    origins.OutputPoint.push_back(point == None ? None : joined.OutputPoint[point]);
  }
}
}

void FillJoined(const WholeSurface& whole, const RegionParts& parts, JoinedRegions& joined,
  const RequestedArrays& requested, Result& result)
{
  CountPoints(whole.Cleaned, joined, result);
  if (requested.Distances || requested.Origins)
  {
    FillPoints(parts, joined, &Result::Distance, result);
    FillPoints(parts, joined, &Result::RunningError, result);
  }
  if (requested.ErrorBound)
  {
    FillPoints(parts, joined, &Result::ErrorBound, result);
  }
  if (requested.Origins)
  {
    FillOrigins(whole.Cleaned, parts, joined, result.Origins);
  }
  result.Surface = std::move(joined.Surface);
}
}
