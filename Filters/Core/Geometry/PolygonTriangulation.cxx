// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"

#include "CornerGrid.h"
#include "ExactPredicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
double Length(const Vector3& vector)
{
  return std::sqrt(Dot(vector, vector));
}

constexpr std::size_t SmallPolygon = 32; // whose corners are all compared with an ear
}

class PolygonTriangulation::Clipper
{
public:
  explicit Clipper(const std::vector<Vector3>& points)
    : Points(points)
  {
  }

  bool Append(const std::vector<Index>& corners, std::vector<Triangle>& triangles)
  {
    this->Corners.clear();
    std::copy_if(corners.begin(), corners.end(), std::back_inserter(this->Corners),
      [this](Index corner)
      { return this->Corners.empty() || !this->AreEqual(this->Corners.back(), corner); });
    while (this->Corners.size() > 1 && this->AreEqual(this->Corners.front(), this->Corners.back()))
    {
      this->Corners.pop_back();
    }
    if (this->Corners.size() < 3)
    {
      return false;
    }
    this->FindPlane();
    if (this->Corners.size() == 4)
    {
      this->AppendQuadrilateral(triangles);
    }
    else
    {
      this->Clip(triangles);
    }
    return true;
  }

private:
  /// A corner and the measure of its triangle when it was queued.
  struct Candidate
  {
    std::size_t Round;
    double Measure;
    std::size_t Corner;
    std::size_t Version;

    bool operator<(const Candidate& other) const // the least is the top of a queue
    {
      return std::tie(this->Round, this->Measure, this->Corner) >
        std::tie(other.Round, other.Measure, other.Corner);
    }
  };
  using Queue = std::priority_queue<Candidate>;

  /// A corner that has not been clipped.
  struct Corner
  {
    std::size_t Previous = 0;
    std::size_t Next = 0;
    std::size_t Version = 0; // changes with its triangle
    std::size_t Round = 0;   // later than that of all clipped neighbors
    bool IsClipped = false;
    bool IsConvex = false;
    // corners that are no ears because their triangle contains this one
    std::vector<std::size_t> Waiting = {};
  };

  const Vector3& PointOf(Index corner) const
  {
    return this->Points[static_cast<std::size_t>(corner)];
  }
  const Vector3& At(std::size_t corner) const { return this->PointOf(this->Corners[corner]); }

  bool AreEqual(Index a, Index b) const { return a == b || this->PointOf(a) == this->PointOf(b); }

  Vector3 CrossAt(std::size_t previous, std::size_t corner, std::size_t next) const
  {
    return (this->At(corner) - this->At(previous)).cross(this->At(next) - this->At(previous));
  }

  /// Axis and direction of the projection.
  void FindPlane()
  {
    const std::size_t count = this->Corners.size();
    Vector3 normal = Vector3::Zero();
    Vector3 largest = Vector3::Zero();
    double size = 0.0;
    for (std::size_t i = 2; i < count; ++i)
    {
      normal += this->CrossAt(0, i - 1, i);
      const Vector3 cross = this->CrossAt(i - 2, i - 1, i);
      largest = Dot(cross, cross) > Dot(largest, largest) ? cross : largest;
      const Vector3 side = this->At(i) - this->At(0);
      size = std::max(size, Dot(side, side));
    }
    constexpr double rounding = 1e-12; // of the sum, relative to the square of the size
    if (!(Length(normal) > rounding * size))
    {
      normal = largest;
    }
    normal.cwiseAbs().maxCoeff(&this->Axis);
    this->Direction = normal[this->Axis] < 0.0 ? -1 : 1;
  }

  int OrientationOf(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    return this->Direction * ProjectedOrientation(a, b, c, this->Axis);
  }

  bool IsConvexAt(std::size_t previous, std::size_t corner, std::size_t next) const
  {
    return this->OrientationOf(this->At(previous), this->At(corner), this->At(next)) > 0;
  }

  void AppendQuadrilateral(std::vector<Triangle>& triangles) const
  {
    const bool hasFirst = this->IsConvexAt(0, 1, 2) && this->IsConvexAt(2, 3, 0);
    const bool hasSecond = this->IsConvexAt(3, 0, 1) && this->IsConvexAt(1, 2, 3);
    const double first = Length(this->At(2) - this->At(0));
    const double second = Length(this->At(3) - this->At(1));
    const std::vector<Index>& c = this->Corners;
    if (hasFirst == hasSecond ? first < second : hasFirst)
    {
      triangles.push_back({ c[1], c[2], c[0] });
      triangles.push_back({ c[3], c[0], c[2] });
    }
    else
    {
      triangles.push_back({ c[0], c[1], c[3] });
      triangles.push_back({ c[2], c[3], c[1] });
    }
  }

  CornerGrid::Position ProjectionOf(std::size_t corner) const
  {
    const Vector3& point = this->At(corner);
    return { point[(this->Axis + 1) % 3], point[(this->Axis + 2) % 3] };
  }

  void Clip(std::vector<Triangle>& triangles)
  {
    this->Begin();
    for (std::size_t left = this->Corners.size(); left > 3; --left)
    {
      this->Remove(this->NextEar(), triangles);
    }
    const auto last = std::find_if(
      this->Ring.begin(), this->Ring.end(), [](const Corner& corner) { return !corner.IsClipped; });
    this->AddTriangleOf(static_cast<std::size_t>(last - this->Ring.begin()), triangles);
  }

  void Begin()
  {
    const std::size_t count = this->Corners.size();
    this->Ring.assign(count, {});
    this->Ears = {};
    this->All = {};
    std::vector<CornerGrid::Position> positions;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Ring[i].Previous = (i + count - 1) % count;
      this->Ring[i].Next = (i + 1) % count;
      positions.push_back(this->ProjectionOf(i));
    }
    if (count > SmallPolygon)
    {
      this->Grid.Build(positions);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Measure(i);
    }
  }

  /// Queues a corner whose triangle has changed.
  void Measure(std::size_t i)
  {
    Corner& corner = this->Ring[i];
    ++corner.Version;
    const bool isConvex = this->IsConvexAt(corner.Previous, i, corner.Next);
    const Vector3& a = this->At(corner.Previous);
    const Vector3& b = this->At(i);
    const Vector3& c = this->At(corner.Next);
    const double around = Length(b - a) + Length(c - b) + Length(a - c);
    const double area = Length(this->CrossAt(corner.Previous, i, corner.Next));
    const double measure = isConvex && area > 0.0 ? around * around / area : Infinity;
    const std::size_t round = this->Corners.size() > SmallPolygon ? corner.Round : 0;
    if (isConvex)
    {
      this->Ears.push({ round, measure, i, corner.Version });
    }
    this->All.push({ round, measure, i, corner.Version });
    if (isConvex && !corner.IsConvex)
    {
      this->Release(corner);
    }
    corner.IsConvex = isConvex;
  }

  /// Queues the corners whose triangles contained this one.
  void Release(Corner& corner)
  {
    for (const std::size_t waiting : std::exchange(corner.Waiting, {}))
    {
      const Corner& other = this->Ring[waiting];
      if (!other.IsClipped && other.IsConvex)
      {
        this->Measure(waiting);
      }
    }
  }

  /// The next ear; without any, the most similar corner.
  std::size_t NextEar()
  {
    while (const std::optional<std::size_t> corner = this->Take(this->Ears))
    {
      const Index obstacle = this->ObstacleOf(*corner);
      if (obstacle == None)
      {
        return *corner;
      }
      this->Ring[static_cast<std::size_t>(obstacle)].Waiting.push_back(*corner);
    }
    return *this->Take(this->All);
  }

  /// The top of a queue among corners whose triangle is still the same.
  std::optional<std::size_t> Take(Queue& queue) const
  {
    while (!queue.empty())
    {
      const Candidate top = queue.top();
      queue.pop();
      const Corner& corner = this->Ring[top.Corner];
      if (!corner.IsClipped && corner.Version == top.Version)
      {
        return top.Corner;
      }
    }
    return {};
  }

  /// A reflex corner in the triangle of a convex corner; None if there is none.
  Index ObstacleOf(std::size_t ear) const
  {
    const std::size_t previous = this->Ring[ear].Previous;
    const std::size_t next = this->Ring[ear].Next;
    const Vector3& a = this->At(previous);
    const Vector3& b = this->At(ear);
    const Vector3& c = this->At(next);
    const auto isInside = [&](std::size_t i)
    {
      const Corner& corner = this->Ring[i];
      const Vector3& p = this->At(i);
      return !corner.IsClipped && !corner.IsConvex && i != previous && i != next && p != a &&
        p != b && p != c && this->OrientationOf(a, b, p) >= 0 &&
        this->OrientationOf(b, c, p) >= 0 && this->OrientationOf(c, a, p) >= 0;
    };
    if (this->Ring.size() > SmallPolygon)
    {
      CornerGrid::Position least = this->ProjectionOf(ear);
      CornerGrid::Position most = least;
      for (const std::size_t corner : { previous, next })
      {
        const CornerGrid::Position position = this->ProjectionOf(corner);
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
          least[axis] = std::min(least[axis], position[axis]);
          most[axis] = std::max(most[axis], position[axis]);
        }
      }
      return this->Grid.Find(least, most, isInside);
    }
    std::size_t i = this->Ring[next].Next;
    while (i != previous && !isInside(i))
    {
      i = this->Ring[i].Next;
    }
    return i == previous ? None : static_cast<Index>(i);
  }

  void AddTriangleOf(std::size_t i, std::vector<Triangle>& triangles) const
  {
    const Corner& corner = this->Ring[i];
    triangles.push_back(
      { this->Corners[corner.Previous], this->Corners[i], this->Corners[corner.Next] });
  }

  void Remove(std::size_t i, std::vector<Triangle>& triangles)
  {
    this->AddTriangleOf(i, triangles);
    Corner& corner = this->Ring[i];
    corner.IsClipped = true;
    this->Ring[corner.Previous].Next = corner.Next;
    this->Ring[corner.Next].Previous = corner.Previous;
    for (const std::size_t neighbor : { corner.Previous, corner.Next })
    {
      Corner& other = this->Ring[neighbor];
      other.Round = std::max(other.Round, corner.Round + 1);
      this->Measure(neighbor);
    }
    this->Release(corner);
  }

  const std::vector<Vector3>& Points;
  std::vector<Index> Corners;
  Eigen::Index Axis = 0;
  int Direction = 1;
  std::vector<Corner> Ring;
  Queue Ears; // convex corners
  Queue All;
  CornerGrid Grid;
};

PolygonTriangulation::PolygonTriangulation(const std::vector<Vector3>& points)
  : Internal(std::make_unique<Clipper>(points))
{
}

PolygonTriangulation::~PolygonTriangulation() = default;

//------------------------------------------------------------------------------
bool PolygonTriangulation::Append(
  const std::vector<Index>& corners, std::vector<Triangle>& triangles)
{
  return this->Internal->Append(corners, triangles);
}

//------------------------------------------------------------------------------
bool AppendStrip(const std::vector<Index>& corners, std::vector<Triangle>& triangles)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    const bool isTurned = i % 2 == 1;
    triangles.push_back(
      { corners[isTurned ? i - 1 : i - 2], corners[isTurned ? i - 2 : i - 1], corners[i] });
  }
  return corners.size() >= 3;
}
}
