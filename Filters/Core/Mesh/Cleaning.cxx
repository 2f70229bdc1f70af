// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cleaning.h"

#include "EdgeGroups.h"
#include "Geometry/TriangleGeometry.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double HugeCoordinate = 1e30; // mm
constexpr std::size_t MostTriangles = std::numeric_limits<Index>::max() / 4;
constexpr std::uint64_t ChecksumStart = 14695981039346656037ULL;
constexpr std::uint64_t ChecksumFactor = 1099511628211ULL;

std::uint64_t Bits(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// Equal points have equal keys; -0 and +0 are equal, so that zero is added.
std::uint64_t HashOf(const Vector3& p)
{
  std::uint64_t hash = ChecksumStart;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    hash = (hash ^ Bits(p[i] + 0.0)) * ChecksumFactor;
    hash ^= hash >> 29;
  }
  return hash;
}

/// Finds the point already entered with the same coordinates: open addressing, never more than half full.
class PointFinder
{
public:
  PointFinder(const std::vector<Vector3>& points, std::size_t count)
    : Points(points)
  {
    std::size_t size = 16;
    while (size < 2 * count)
    {
      size *= 2;
    }
    this->Table.assign(size, None);
  }

  /// The first input point entered that equals this one: itself if it is new.
  Index Enter(Index point)
  {
    const Vector3& position = this->Points[point];
    std::size_t slot = HashOf(position) & (this->Table.size() - 1);
    while (this->Table[slot] != None && this->Points[this->Table[slot]] != position)
    {
      slot = (slot + 1) & (this->Table.size() - 1);
    }
    if (this->Table[slot] == None)
    {
      this->Table[slot] = point;
    }
    return this->Table[slot];
  }

private:
  const std::vector<Vector3>& Points;
  std::vector<Index> Table;
};

/// Counts one more and remembers the first.
void Find(std::int64_t& count, std::int64_t& first, std::size_t id)
{
  first = count++ == 0 ? static_cast<std::int64_t>(id) : first;
}

void CheckPoints(const Surface& input, CleanSurface& clean)
{
  CleaningStatistics& found = clean.Statistics;
  for (std::size_t p = 0; p < input.Points.size(); ++p)
  {
    const Vector3& position = input.Points[p];
    if (!std::isfinite(position[0]) || !std::isfinite(position[1]) || !std::isfinite(position[2]))
    {
      Find(found.NonFinitePoints, found.FirstNonFinitePoint, p);
    }
    else if (position.cwiseAbs().maxCoeff() > HugeCoordinate)
    {
      Find(found.HugePoints, found.FirstHugePoint, p);
    }
  }
  if (found.NonFinitePoints > 0)
  {
    clean.Status = InputStatus::NonFinitePoints;
  }
  else if (found.HugePoints > 0)
  {
    clean.Status = InputStatus::HugeCoordinates;
  }
}

void CheckTriangles(const Surface& input, CleanSurface& clean)
{
  const std::size_t numberOfPoints = input.Points.size();
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    bool inRange = true;
    for (const Index corner : input.Triangles[t])
    {
      inRange = inRange && corner >= 0 && static_cast<std::size_t>(corner) < numberOfPoints;
    }
    if (!inRange)
    {
      Find(clean.Statistics.TrianglesOutOfRange, clean.Statistics.FirstTriangleOutOfRange, t);
    }
  }
  if (clean.Statistics.TrianglesOutOfRange > 0)
  {
    clean.Status = InputStatus::IndexOutOfRange;
  }
}

/// Fills Status with the first thing that makes the input unusable.
void Check(const Surface& input, CleanSurface& clean)
{
  clean.Statistics.PointsRead = static_cast<std::int64_t>(input.Points.size());
  clean.Statistics.TrianglesRead = static_cast<std::int64_t>(input.Triangles.size());
  if (input.Triangles.size() > MostTriangles ||
    input.Points.size() > std::numeric_limits<Index>::max())
  {
    clean.Status = InputStatus::TooManyTriangles;
    return;
  }
  CheckPoints(input, clean);
  if (clean.Status == InputStatus::Good)
  {
    CheckTriangles(input, clean);
  }
  if (clean.Status == InputStatus::Good && input.Triangles.empty())
  {
    clean.Status = input.Points.empty() ? InputStatus::Empty : InputStatus::NoTriangles;
  }
}

/// Of each input point that a triangle uses: the input point that stands for it; None for the others.
std::vector<Index> Representatives(const Surface& input, bool mergePoints)
{
  std::vector<Index> representative(input.Points.size(), None);
  for (const Triangle& corners : input.Triangles)
  {
    for (const Index corner : corners)
    {
      representative[corner] = corner;
    }
  }
  if (mergePoints)
  {
    PointFinder finder(input.Points, input.Points.size());
    for (Index& point : representative)
    {
      point = point == None ? None : finder.Enter(point);
    }
  }
  return representative;
}

bool HasRepeatedCorner(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Drops triangles of zero area that share at most one edge (with three different corners in `triangles`).
std::vector<char> FlatTrianglesToDrop(
  const std::vector<Triangle>& triangles, const std::vector<Vector3>& points)
{
  std::vector<char> drop(triangles.size(), 0);
  bool any = false;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    drop[t] = AreaVector(points[c[0]], points[c[1]], points[c[2]]).isZero(0.0) ? 1 : 0;
    any = any || drop[t] != 0;
  }
  if (!any)
  {
    return drop;
  }
  std::vector<char> sharedEdges(triangles.size(), 0);
  VisitEdgeGroups(triangles, points.size(),
    [&](const Index* first, const Index* last)
    {
      for (const Index* h = first; h != last && last - first > 1; ++h)
      {
        ++sharedEdges[*h / 3];
      }
    });
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    drop[t] = drop[t] != 0 && sharedEdges[t] <= 1 ? 1 : 0;
  }
  return drop;
}

void CountDropped(CleaningStatistics& statistics, Index inputTriangle)
{
  if (statistics.DroppedTriangles++ == 0 || inputTriangle < statistics.FirstDroppedTriangle)
  {
    statistics.FirstDroppedTriangle = inputTriangle;
  }
}

/// Triangles in terms of input points that stand for themselves; the ones without area are gone.
void KeepTriangles(
  const Surface& input, const std::vector<Index>& representative, CleanSurface& clean)
{
  std::vector<Triangle> triangles;
  std::vector<Index> ids;
  triangles.reserve(input.Triangles.size());
  ids.reserve(input.Triangles.size());
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    const Triangle& c = input.Triangles[t];
    const Triangle corners = { representative[c[0]], representative[c[1]], representative[c[2]] };
    if (HasRepeatedCorner(corners))
    {
      CountDropped(clean.Statistics, static_cast<Index>(t));
      continue;
    }
    triangles.push_back(corners);
    ids.push_back(static_cast<Index>(t));
  }
  const std::vector<char> drop = FlatTrianglesToDrop(triangles, input.Points);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (drop[t] != 0)
    {
      CountDropped(clean.Statistics, ids[t]);
      continue;
    }
    clean.Surface.Triangles.push_back(triangles[t]);
    clean.InputTriangle.push_back(ids[t]);
  }
}

/// Numbers the points that kept triangles use in input order and renames the corners.
void NumberPoints(
  const Surface& input, const std::vector<Index>& representative, CleanSurface& clean)
{
  std::vector<Index> number(input.Points.size(), None);
  for (const Triangle& corners : clean.Surface.Triangles)
  {
    for (const Index corner : corners)
    {
      number[corner] = 0;
    }
  }
  clean.PointOfInput.assign(input.Points.size(), None);
  for (std::size_t p = 0; p < input.Points.size(); ++p)
  {
    const Index stand = representative[p];
    if (stand == None || number[stand] == None)
    {
      ++clean.Statistics.UnusedPoints;
      continue;
    }
    if (stand == static_cast<Index>(p))
    {
      number[p] = static_cast<Index>(clean.InputPoint.size());
      clean.InputPoint.push_back(stand);
      clean.InputPointCount.push_back(0);
    }
    clean.PointOfInput[p] = number[stand];
    ++clean.InputPointCount[number[stand]];
    clean.Statistics.MergedPoints += stand != static_cast<Index>(p) ? 1 : 0;
  }
  for (Triangle& corners : clean.Surface.Triangles)
  {
    for (Index& corner : corners)
    {
      corner = number[corner];
    }
  }
}

void MovePointsToOrigin(const Surface& input, CleanSurface& clean)
{
  clean.Origin = input.Points[clean.InputPoint[0]];
  for (const Index p : clean.InputPoint)
  {
    clean.Origin = clean.Origin.cwiseMin(input.Points[p]);
  }
  clean.Surface.Points.reserve(clean.InputPoint.size());
  for (const Index p : clean.InputPoint)
  {
    clean.Surface.Points.push_back(input.Points[p] - clean.Origin);
  }
}
}

CleanSurface Clean(const Surface& input, bool mergePoints)
{
  CleanSurface clean;
  Check(input, clean);
  if (clean.Status != InputStatus::Good)
  {
    return clean;
  }
  const std::vector<Index> representative = Representatives(input, mergePoints);
  KeepTriangles(input, representative, clean);
  if (clean.Surface.Triangles.empty())
  {
    clean.Status = InputStatus::NoTriangles;
    return clean;
  }
  NumberPoints(input, representative, clean);
  MovePointsToOrigin(input, clean);
  return clean;
}

std::uint64_t Checksum(const Surface& surface)
{
  std::uint64_t sum = ChecksumStart;
  for (const Vector3& point : surface.Points)
  {
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      sum = (sum ^ Bits(point[i])) * ChecksumFactor;
    }
  }
  for (const Triangle& corners : surface.Triangles)
  {
    for (const Index corner : corners)
    {
      sum = (sum ^ static_cast<std::uint64_t>(corner)) * ChecksumFactor;
    }
  }
  return sum;
}
}
