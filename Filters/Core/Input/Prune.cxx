// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Prune.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/Statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
/// The components of a cleaned surface and their measurements.
class Census
{
public:
  Census(const CleanSurface& cleaned, int threads)
    : Clean(cleaned)
    , Whole(FindComponents(cleaned.Surface))
    , All(static_cast<std::size_t>(Whole.Count))
    , Low(All.size(), Vector3::Constant(std::numeric_limits<double>::infinity()))
    , High(All.size(), -Low[0])
  {
    this->AddTriangles();
    this->ForgetOpenVolumes(threads);
    this->MeasureBoxes();
  }

  std::size_t Of(std::size_t triangle) const
  {
    const Index corner = this->Clean.Surface.Triangles[triangle][0];
    return static_cast<std::size_t>(this->Whole.OfPoint[corner]);
  }

  const std::vector<PrunedComponent>& Found() const { return this->All; }

private:
  void AddTriangles()
  {
    const std::vector<Vector3>& points = this->Clean.Surface.Points;
    const std::vector<Triangle>& triangles = this->Clean.Surface.Triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Triangle& c = triangles[t];
      const Vector3 area = AreaVector(points[c[0]], points[c[1]], points[c[2]]);
      PrunedComponent& component = this->All[this->Of(t)];
      ++component.Triangles;
      component.Area += area.norm();
      component.Volume += area.dot(points[c[0]]) / 3.0;
    }
  }

  /// Only a closed and consistently oriented component has a volume.
  void ForgetOpenVolumes(int threads)
  {
    const CleanSurface& clean = this->Clean;
    const EdgeMatching matching(clean.Surface.Triangles, clean.Surface.Points.size(), threads);
    for (std::size_t t = 0; t < clean.Surface.Triangles.size(); ++t)
    {
      const Index* twins = matching.Twins().data() + 4 * t;
      if (std::any_of(twins, twins + 3, [](Index twin) { return twin < 0; }))
      {
        this->All[this->Of(t)].Volume = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }

  void MeasureBoxes()
  {
    for (std::size_t p = 0; p < this->Clean.Surface.Points.size(); ++p)
    {
      const auto component = static_cast<std::size_t>(this->Whole.OfPoint[p]);
      this->Low[component] = this->Low[component].cwiseMin(this->Clean.Surface.Points[p]);
      this->High[component] = this->High[component].cwiseMax(this->Clean.Surface.Points[p]);
    }
    for (std::size_t c = 0; c < this->All.size(); ++c)
    {
      this->All[c].Volume = std::abs(this->All[c].Volume);
      this->All[c].Size = (this->High[c] - this->Low[c]).maxCoeff();
      this->All[c].Center = 0.5 * (this->Low[c] + this->High[c]) + this->Clean.Origin;
    }
  }

  const CleanSurface& Clean;
  Components Whole;
  std::vector<PrunedComponent> All;
  std::vector<Vector3> Low; // mm, of the boxes
  std::vector<Vector3> High;
};

/// No value is below a limit of 0, and a volume of NaN is below no limit.
bool IsBelow(const PrunedComponent& component, const Options& limits)
{
  return component.Triangles < limits.PruneTriangles || component.Size < limits.PruneSize ||
    component.Area < limits.PruneArea || component.Volume < limits.PruneVolume;
}

/// Keeps the triangles of the remaining components, renumbers their points in the same order, and moves the origin to the
/// least corner of their bounding box.
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

PruneFigures Prune(const Surface& input, const Options& options, CleanSurface& cleaned)
{
  PruneFigures figures;
  figures.IsRequested = options.Prunes();
  if (!figures.IsRequested)
  {
    return figures;
  }
  const Census census(cleaned, options.NumberOfThreads);
  for (const PrunedComponent& component : census.Found())
  {
    if (IsBelow(component, options))
    {
      figures.Triangles += component.Triangles;
      figures.Components.push_back(component);
    }
  }
  if (!figures.Components.empty() && figures.Components.size() < census.Found().size())
  {
    Remover(input, cleaned)
      .Run([&](std::size_t t) { return IsBelow(census.Found()[census.Of(t)], options); });
  }
  figures.TookAll = figures.Components.size() == census.Found().size();
  std::stable_sort(figures.Components.begin(), figures.Components.end(),
    [](const PrunedComponent& a, const PrunedComponent& b) { return a.Size > b.Size; });
  return figures;
}
}
