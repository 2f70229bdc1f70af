// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloseBoundaries.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
class Closing
{
public:
  Closing(Surface& surface, const ContourTriangulator& triangulate)
    : CappedSurface(surface)
    , Triangulate(triangulate)
    , PointsBefore(surface.Points.size())
    , Boundaries(FindBoundaryLoops(surface))
    , IsClosed(Boundaries.Loops.size(), false)
  {
  }

  void Close(const CapOptions& options)
  {
    for (const std::vector<std::size_t>& group :
      GroupByEndPlanes(this->CappedSurface, this->Boundaries.Loops, options.PlaneTolerance))
    {
      this->Fill(group);
    }
    for (std::size_t loop = 0; options.ClosesAll && loop < this->IsClosed.size(); ++loop)
    {
      if (!this->IsClosed[loop])
      {
        this->Fill({ loop });
      }
    }
  }

  CapsOfSurface TakeResult()
  {
    CapsOfSurface& made = this->Caps;
    const auto closed = std::count(this->IsClosed.begin(), this->IsClosed.end(), true);
    made.ClosedLoops = static_cast<Index>(closed);
    made.OpenLoops =
      static_cast<Index>(this->IsClosed.size() + this->Boundaries.NonManifold) - made.ClosedLoops;
    made.Points.assign(
      this->CappedSurface.Points.begin() + static_cast<std::ptrdiff_t>(this->PointsBefore),
      this->CappedSurface.Points.end());
    made.Ends = std::move(this->Boundaries.SplitEdges);
    return std::move(made);
  }

private:
  void Fill(const std::vector<std::size_t>& group)
  {
    for (const Cap& cap :
      FillLoops(this->CappedSurface, this->Boundaries, group, this->Triangulate))
    {
      const std::size_t beside = this->Boundaries.Loops[cap.Loops.front()].Triangle;
      for (const std::size_t loop : cap.Loops)
      {
        this->IsClosed[loop] = true;
      }
      for (const Triangle& corners : cap.Triangles)
      {
        this->Caps.Triangles.push_back(corners);
        this->Caps.Neighbors.push_back(static_cast<Index>(beside));
        this->Caps.Area += this->AreaOf(corners);
      }
      ++this->Caps.NumberOfCaps;
    }
  }

  double AreaOf(const Triangle& corners) const // mm^2
  {
    const auto at = [this](Index p) -> const Vector3&
    { return this->CappedSurface.Points[static_cast<std::size_t>(p)]; };
    return 0.5 * (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])).norm();
  }

  Surface& CappedSurface;
  const ContourTriangulator& Triangulate;
  std::size_t PointsBefore;
  BoundaryLoops Boundaries;
  std::vector<bool> IsClosed; // of each loop
  CapsOfSurface Caps;
};
}

CapsOfSurface CloseBoundaries(
  Surface surface, const CapOptions& options, const ContourTriangulator& triangulate)
{
  Closing closing(surface, triangulate);
  closing.Close(options);
  return closing.TakeResult();
}
}
