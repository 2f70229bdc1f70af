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
    : Whole(surface)
    , Triangulate(triangulate)
    , PointsBefore(surface.Points.size())
    , Found(FindBoundaryLoops(surface))
    , IsClosed(Found.Loops.size(), false)
  {
  }

  void Close(const CapOptions& options)
  {
    for (const std::vector<std::size_t>& group :
      GroupByEndPlanes(this->Whole, this->Found.Loops, options.PlaneTolerance))
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
    CapsOfSurface& made = this->Made;
    const auto closed = std::count(this->IsClosed.begin(), this->IsClosed.end(), true);
    made.ClosedLoops = static_cast<Index>(closed);
    made.OpenLoops =
      static_cast<Index>(this->IsClosed.size() + this->Found.NonManifold) - made.ClosedLoops;
    made.Points.assign(this->Whole.Points.begin() + static_cast<std::ptrdiff_t>(this->PointsBefore),
      this->Whole.Points.end());
    made.Ends = std::move(this->Found.Added);
    return std::move(made);
  }

private:
  void Fill(const std::vector<std::size_t>& group)
  {
    for (const Cap& cap : FillLoops(this->Whole, this->Found, group, this->Triangulate))
    {
      const std::size_t beside = this->Found.Loops[cap.Loops.front()].Triangle;
      for (const std::size_t loop : cap.Loops)
      {
        this->IsClosed[loop] = true;
      }
      for (const Triangle& corners : cap.Triangles)
      {
        this->Made.Triangles.push_back(corners);
        this->Made.Neighbors.push_back(static_cast<Index>(beside));
        this->Made.Area += this->AreaOf(corners);
      }
      ++this->Made.NumberOfCaps;
    }
  }

  double AreaOf(const Triangle& corners) const // mm^2
  {
    const auto at = [this](Index p) -> const Vector3&
    { return this->Whole.Points[static_cast<std::size_t>(p)]; };
    return 0.5 * (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])).norm();
  }

  Surface& Whole;
  const ContourTriangulator& Triangulate;
  std::size_t PointsBefore;
  BoundaryLoops Found;
  std::vector<bool> IsClosed; // of each loop
  CapsOfSurface Made;
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
