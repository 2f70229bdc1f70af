// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpatialOrder.h"

#include "Base/LargeArray.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr int BitsOfAxis = 21;
/// Slightly less than 2^21 and no simple fraction of it, so that points in regular rows seldom lie
/// on the boundary of two cells, where another unit of length would round them to the other side.
constexpr double CellsAcross = 2038437.618033988;
constexpr double MinLength =
  1e-290; // mm; the number of cells per mm would overflow for smaller boxes
constexpr int BitsOfDigit = 11;
constexpr std::size_t Digits = std::size_t(1) << BitsOfDigit;
constexpr int BitsOfIndex = 31;
/// Fewer points than this are sorted by comparison.
constexpr std::size_t SmallBin = 512;

/// Inserts two zeros after each of the lowest 21 bits.
std::uint64_t Spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

/// The grid around the points.
class Curve
{
public:
  Curve(const std::vector<Vector3>& points, int threads)
    : Points(points)
    , Low(points[0])
  {
    struct Box
    {
      Vector3 Low, High;
    };
    std::vector<Box> boxes(NumberOfBlocks(points.size()));
    ForEachBlock(points.size(), threads,
      [&](std::size_t block, std::size_t first, std::size_t last)
      {
        Box box = { points[first], points[first] };
        for (std::size_t p = first; p < last; ++p)
        {
          box = { box.Low.cwiseMin(points[p]), box.High.cwiseMax(points[p]) };
        }
        boxes[block] = box;
      });
    Vector3 high = this->Low;
    for (const Box& box : boxes)
    {
      this->Low = this->Low.cwiseMin(box.Low);
      high = high.cwiseMax(box.High);
    }
    this->Scale = CellsAcross / std::max(MinLength, (high - this->Low).maxCoeff());
  }

  /// Position on the curve, 63 bits.
  std::uint64_t Position(Index point) const
  {
    const Vector3 cell = (this->Points[point] - this->Low) * this->Scale;
    const auto along = [&](Eigen::Index axis)
    { return Spread(static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]))); };
    return along(0) << 2 | along(1) << 1 | along(2);
  }

  bool IsBefore(Index a, Index b) const
  {
    const std::uint64_t positionOfA = this->Position(a);
    const std::uint64_t positionOfB = this->Position(b);
    const Vector3& p = this->Points[a];
    const Vector3& q = this->Points[b];
    return positionOfA != positionOfB
      ? positionOfA < positionOfB
      : std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  }

private:
  const std::vector<Vector3>& Points;
  Vector3 Low;        // mm
  double Scale = 1.0; // cells per mm
};

/// Entries with the first 33 bits of the position on the curve and the index of the point, sorted
/// by three digits.
using CurveEntry = std::uint64_t;

Index PointOf(CurveEntry entry)
{
  return static_cast<Index>(entry & ((CurveEntry(1) << BitsOfIndex) - 1));
}

LargeArray<CurveEntry> Entries(const Curve& curve, std::size_t count, int threads)
{
  LargeArray<CurveEntry> entries(count);
  ForEachId(count, threads,
    [&](std::size_t p)
    {
      const std::uint64_t position = curve.Position(static_cast<Index>(p));
      entries[p] = position >> (3 * BitsOfAxis - 3 * BitsOfDigit) << BitsOfIndex | p;
    });
  return entries;
}

/// One pass of radix sort. Returns the first entry of each digit and, finally, the end.
std::vector<std::size_t> Distribute(
  const CurveEntry* from, std::size_t count, int shift, CurveEntry* to)
{
  const auto digit = [=](CurveEntry entry) { return (entry >> shift) & (Digits - 1); };
  std::vector<std::size_t> begins(Digits + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    ++begins[digit(from[i]) + 1];
  }
  for (std::size_t d = 0; d < Digits; ++d)
  {
    begins[d + 1] += begins[d];
  }
  std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    to[next[digit(from[i])]++] = from[i];
  }
  return begins;
}

/// Sorts entries of the same first digit by the other two; `spare` is as long.
void SortBin(CurveEntry* entries, CurveEntry* spare, std::size_t count)
{
  if (count < SmallBin)
  {
    std::sort(entries, entries + count); // no ties: the index of the point is included
    return;
  }
  Distribute(entries, count, BitsOfIndex, spare);
  Distribute(spare, count, BitsOfIndex + BitsOfDigit, entries);
}

/// Sorts the few entries with equal 33 bits by all 63 bits, those of one cell by their coordinates.
void SortTies(const Curve& curve, CurveEntry* entries, std::size_t count)
{
  for (std::size_t first = 0; first < count;)
  {
    std::size_t last = first + 1;
    while (last < count && entries[last] >> BitsOfIndex == entries[first] >> BitsOfIndex)
    {
      ++last;
    }
    if (last - first > 1) // the library allocates memory even to sort one entry
    {
      std::stable_sort(entries + first, entries + last,
        [&](CurveEntry a, CurveEntry b) { return curve.IsBefore(PointOf(a), PointOf(b)); });
    }
    first = last;
  }
}

/// For each new index, the old one. Triangles are sorted by the new indices of their corners,
/// starting at the smallest one.
std::vector<Index> OrderByLeastPoint(
  const std::vector<Triangle>& triangles, std::size_t numberOfPoints)
{
  std::vector<Index> start(numberOfPoints + 1, 0);
  for (const Triangle& t : triangles)
  {
    ++start[std::min({ t[0], t[1], t[2] }) + 1];
  }
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    start[p + 1] += start[p];
  }
  std::vector<Index> order(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    order[start[std::min({ c[0], c[1], c[2] })]++] = static_cast<Index>(t);
  }
  for (std::size_t p = 0; p < numberOfPoints; ++p) // each start is now the end of its point
  {
    const auto fromLeast = [&](Index t) // the other corners
    {
      const Triangle& c = triangles[t];
      const std::size_t k = c[0] == static_cast<Index>(p) ? 0
        : c[1] == static_cast<Index>(p)                   ? 1
                                                          : 2;
      const auto second = static_cast<std::uint64_t>(c[(k + 1) % 3]);
      return second << 32U | static_cast<std::uint64_t>(c[(k + 2) % 3]);
    };
    const auto first = order.begin() + (p == 0 ? 0 : start[p - 1]);
    std::sort(first, order.begin() + start[p],
      [&](Index a, Index b)
      {
        const std::uint64_t ofA = fromLeast(a);
        const std::uint64_t ofB = fromLeast(b);
        return ofA != ofB ? ofA < ofB : a < b;
      });
  }
  return order;
}

template <typename Value>
void Permute(std::vector<Value>& values, const std::vector<Index>& order, int threads)
{
  std::vector<Value> permuted;
  ReserveLarge(permuted, values.size());
  permuted.resize(values.size());
  ForEachId(order.size(), threads, [&](std::size_t i) { permuted[i] = values[order[i]]; });
  values = std::move(permuted);
}

/// For each old index, the new one.
std::vector<Index> Inverse(const std::vector<Index>& order, int threads)
{
  std::vector<Index> inverse(order.size());
  ForEachId(
    order.size(), threads, [&](std::size_t i) { inverse[order[i]] = static_cast<Index>(i); });
  return inverse;
}
}

std::vector<Index> CurveOrder(const std::vector<Vector3>& points, int threads)
{
  if (points.empty())
  {
    return {};
  }
  const Curve curve(points, threads);
  LargeArray<CurveEntry> unsorted = Entries(curve, points.size(), threads);
  LargeArray<CurveEntry> entries(points.size());
  const std::vector<std::size_t> bins =
    Distribute(unsorted.data(), points.size(), 64 - BitsOfDigit, entries.data());
  std::vector<Index> order(points.size());
  ForEachPart(Digits, threads, Monitor(),
    [&](std::size_t bin)
    {
      const std::size_t first = bins[bin];
      const std::size_t count = bins[bin + 1] - first;
      SortBin(entries.data() + first, unsorted.data() + first, count);
      SortTies(curve, entries.data() + first, count);
      for (std::size_t i = first; i < first + count; ++i)
      {
        order[i] = PointOf(entries[i]);
      }
    });
  return order;
}

namespace
{
/// The same for sorted points with duplicates at the end, by ascending original vertex.
std::vector<Index> OrderWithDuplicates(
  const std::vector<Vector3>& points, const std::vector<Index>& originals)
{
  const auto count = static_cast<Index>(points.size());
  Index end = count;
  while (end > 0 && originals[end - 1] != end - 1)
  {
    --end;
  }
  Index duplicate = end;
  std::vector<Index> order;
  order.reserve(points.size());
  for (Index p = 0; p < end; ++p)
  {
    order.push_back(p);
    const bool isLastThere = p + 1 == end || points[p] != points[p + 1];
    for (; isLastThere && duplicate < count && originals[duplicate] <= p; ++duplicate)
    {
      order.push_back(duplicate);
    }
  }
  return order;
}
}

void SortAlongCurve(CleanSurface& clean, int threads)
{
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  const std::vector<Index> order = originals.empty()
    ? CurveOrder(clean.Surface.Points, threads)
    : OrderWithDuplicates(clean.Surface.Points, originals);
  Permute(clean.Surface.Points, order, threads);
  Permute(clean.InputPoint, order, threads);
  Permute(clean.InputPointCount, order, threads);
  const std::vector<Index> number = Inverse(order, threads);
  ForEachId(clean.PointOfInput.size(), threads,
    [&](std::size_t p)
    {
      Index& point = clean.PointOfInput[p];
      point = point == None ? None : number[point];
    });
  if (!clean.ManifoldPatches.OriginalVertices.empty())
  {
    Permute(clean.ManifoldPatches.OriginalVertices, order, threads);
    for (Index& original : clean.ManifoldPatches.OriginalVertices)
    {
      original = number[original];
    }
  }
  ForEachId(clean.Surface.Triangles.size(), threads,
    [&](std::size_t i)
    {
      Triangle& t = clean.Surface.Triangles[i];
      t = { number[t[0]], number[t[1]], number[t[2]] };
    });
  const std::vector<Index> triangleOrder =
    OrderByLeastPoint(clean.Surface.Triangles, clean.Surface.Points.size());
  Permute(clean.Surface.Triangles, triangleOrder, threads);
  Permute(clean.InputTriangle, triangleOrder, threads);
}
}
