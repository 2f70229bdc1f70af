// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
struct Box
{
  Vector3 Low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 High = -Low;

  void Add(const Surface& surface)
  {
    for (const Triangle& corners : surface.Triangles)
    {
      for (const Index corner : corners)
      {
        this->Low = this->Low.cwiseMin(surface.Points[corner]);
        this->High = this->High.cwiseMax(surface.Points[corner]);
      }
    }
  }
};

/// An offset that can be subtracted from all coordinates between low and high without rounding.
double ExactOrigin(double low, double high)
{
  if (low > 0.0 && high <= 2.0 * low)
  {
    return low;
  }
  return high < 0.0 && low >= 2.0 * high ? high : 0.0;
}
}

//------------------------------------------------------------------------------
bool HasUsableTriangles(const Surface& surface)
{
  const auto isUsable = [&](Index point)
  {
    return point >= 0 && static_cast<std::size_t>(point) < surface.Points.size() &&
      IsUsable(surface.Points[point]);
  };
  return std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& corners) { return std::all_of(corners.begin(), corners.end(), isUsable); });
}

//------------------------------------------------------------------------------
Frame FindFrame(const Surface& reference, const Surface& result)
{
  Box box;
  box.Add(reference);
  box.Add(result);
  Frame frame;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    frame.Origin[axis] = ExactOrigin(box.Low[axis], box.High[axis]);
  }
  frame.Extent = std::max((box.Low - frame.Origin).lpNorm<Eigen::Infinity>(),
    (box.High - frame.Origin).lpNorm<Eigen::Infinity>());
  return frame;
}

//------------------------------------------------------------------------------
Simplices WholeSurface(const Surface& surface, const EdgeSides& sides, const Frame& frame)
{
  Simplices whole;
  whole.Sides = &sides;
  whole.Corners = surface.Triangles;
  whole.Points.reserve(surface.Points.size());
  for (const Vector3& point : surface.Points)
  {
    whole.Points.push_back(point - frame.Origin);
  }
  return whole;
}

//------------------------------------------------------------------------------
Simplices LimitedPart(const Simplices& whole, const std::vector<double>& limit)
{
  Simplices part;
  part.Points = whole.Points;
  part.PointTolerance = limit;
  for (std::size_t simplex = 0; simplex < whole.Size(); ++simplex)
  {
    Triangle corners = { None, None, None };
    std::size_t count = 0;
    for (const Index corner : whole.Corners[simplex])
    {
      if (corner != None && std::isfinite(limit[corner]))
      {
        corners[count++] = corner;
      }
    }
    if (count > 0)
    {
      part.Corners.push_back(corners);
      part.TriangleIds.push_back(whole.TriangleId(static_cast<Index>(simplex)));
    }
  }
  return part;
}

//------------------------------------------------------------------------------
BoundarySet FindBoundarySet(const Surface& surface, const EdgeSides& sides, const Frame& frame,
  const std::vector<double>& limit)
{
  BoundarySet set;
  std::vector<Index> ids(surface.Points.size(), None);
  for (const BoundaryEdge& edge : FindBoundaries(surface, sides))
  {
    for (const Index point : edge.Points)
    {
      if (ids[point] == None)
      {
        ids[point] = static_cast<Index>(set.Segments.Points.size());
        set.Segments.Points.push_back(surface.Points[point] - frame.Origin);
        if (!limit.empty())
        {
          set.Limit.push_back(limit[point]);
        }
      }
    }
    set.Segments.Corners.push_back({ ids[edge.Points[0]], ids[edge.Points[1]], None });
    set.Segments.TriangleIds.push_back(edge.Triangle);
  }
  return set;
}
}
