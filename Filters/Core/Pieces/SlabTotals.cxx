// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabTotals.h"

#include "Mesh/Statistics.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// mm^3, signed, of the tetrahedra between the triangles and the origin.
double SignedVolume(const Surface& surface)
{
  double volume = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    volume += surface.Points[c[0]].dot(surface.Points[c[1]].cross(surface.Points[c[2]])) / 6.0;
  }
  return volume;
}
}

double MeanEdge(const SurfaceStatistics& surface)
{
  return surface.Faces > 0
    ? std::sqrt(surface.Area / static_cast<double>(surface.Faces) * 4.0 / std::sqrt(3.0))
    : 0.0;
}

//------------------------------------------------------------------------------
Index SlabTotals::RootOf(Index component) const
{
  while (this->Parents[component] != component)
  {
    component = this->Parents[component];
  }
  return component;
}

//------------------------------------------------------------------------------
void SlabTotals::Add(const Slab& slab, const Result& result, const std::vector<char>& isInLower,
  const std::vector<char>& isInUpper)
{
  this->Sum.Faces += result.Report.Input.Faces;
  this->Sum.Area += result.Report.Input.Area;
  this->Sum.Volume += SignedVolume(slab.Surface);
  this->AddEdits(result.Report);
  const CleaningStatistics& cleaning = result.Report.Cleaning;
  this->Cleaning.TrianglesRead += cleaning.TrianglesRead;
  this->Cleaning.PointsRead += cleaning.PointsRead;
  this->Cleaning.MergedPoints += cleaning.MergedPoints;
  this->Cleaning.UnusedPoints += cleaning.UnusedPoints;
  this->Cleaning.DroppedTriangles += cleaning.DroppedTriangles;

  const Components found = FindComponents(result.Surface);
  const Index first = static_cast<Index>(this->Parents.size());
  for (Index i = 0; i < found.Count; ++i)
  {
    this->Parents.push_back(first + i);
  }
  std::map<Coordinates, Index> inPlane;
  for (std::size_t i = 0; i < isInLower.size(); ++i)
  {
    const Vector3& p = result.Surface.Points[i];
    const Coordinates key = { p[0], p[1], p[2] };
    const Index component = first + found.OfPoint[i];
    const auto below = isInLower[i] != 0 ? this->InPlane.find(key) : this->InPlane.end();
    if (below != this->InPlane.end())
    {
      const auto [low, high] =
        std::minmax({ this->RootOf(below->second), this->RootOf(component) });
      this->Parents[high] = low;
    }
    if (isInUpper[i] != 0)
    {
      inPlane.emplace(key, component);
    }
  }
  this->InPlane = std::move(inPlane);
}

//------------------------------------------------------------------------------
void SlabTotals::AddEdits(const Report& report)
{
  this->Collapses += report.Collapses;
  for (std::size_t i = 0; i < NumberOfRejections; ++i)
  {
    this->Rejections[i] += report.Rejections[i];
  }
  this->Seconds.Prepare += report.Seconds.Prepare;
  this->Seconds.Collapse += report.Seconds.Collapse;
  this->Seconds.Decimate += report.Seconds.Decimate;
  this->Seconds.Prove += report.Seconds.Prove;
}

//------------------------------------------------------------------------------
void SlabTotals::AddJunction(const Report& report)
{
  this->AddEdits(report);
}

//------------------------------------------------------------------------------
std::int64_t SlabTotals::NumberOfComponents() const
{
  std::int64_t count = 0;
  for (std::size_t i = 0; i < this->Parents.size(); ++i)
  {
    count += this->Parents[i] == static_cast<Index>(i) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void SlabTotals::Write(Report& report) const
{
  report.Input = this->Sum;
  report.Input.Components = this->NumberOfComponents();
  report.Cleaning = this->Cleaning;
  report.Collapses = this->Collapses;
  report.Rejections = this->Rejections;
  report.Seconds = this->Seconds;
}
}
