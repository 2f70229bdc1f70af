// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cleaning.h"

#include "Base/LargeArray.h"
#include "Base/Parallel.h"
#include "EdgeMatching.h"
#include "Geometry/TriangleGeometry.h"
#include "PointMerging.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxTriangles = std::numeric_limits<Index>::max() / 4;

/// Count and first id.
struct Tally
{
  std::int64_t Count = 0;
  std::int64_t First = -1;

  void Add(std::size_t id)
  {
    this->First = this->Count++ == 0 ? static_cast<std::int64_t>(id) : this->First;
  }
};

/// Finds the ids below count for which isBad(id) holds.
template <typename IsBad>
Tally FindAll(std::size_t count, int threads, const IsBad& isBad)
{
  std::vector<Tally> tallies(NumberOfBlocks(count));
  ForEachBlock(count, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t id = first; id < last; ++id)
      {
        if (isBad(id))
        {
          tallies[block].Add(id);
        }
      }
    });
  Tally all;
  for (const Tally& found : tallies)
  {
    all.First = all.Count == 0 ? found.First : all.First;
    all.Count += found.Count;
  }
  return all;
}

/// Stops at the first kind of defect: triangles with bad points cannot be checked further.
InputStatus CheckPoints(const Surface& input, int threads, CleaningStatistics& found)
{
  const auto isFinite = [](const Vector3& p)
  { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); };
  const auto find = [&](const auto& isBad) { return FindAll(input.Points.size(), threads, isBad); };
  if (find([&](std::size_t p) { return !IsUsable(input.Points[p]); }).Count == 0)
  {
    return InputStatus::Good;
  }
  const Tally wrong = find([&](std::size_t p) { return !isFinite(input.Points[p]); });
  const Tally huge =
    find([&](std::size_t p) { return isFinite(input.Points[p]) && !IsUsable(input.Points[p]); });
  found.NonFinitePoints = wrong.Count;
  found.FirstNonFinitePoint = wrong.First;
  found.HugePoints = huge.Count;
  found.FirstHugePoint = huge.First;
  return wrong.Count > 0 ? InputStatus::NonFinitePoints : InputStatus::HugeCoordinates;
}

InputStatus CheckTriangles(const Surface& input, int threads, CleaningStatistics& found)
{
  const auto numberOfPoints = static_cast<std::uint32_t>(input.Points.size());
  const Tally outside = FindAll(input.Triangles.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = input.Triangles[t]; // negative indices become huge as unsigned numbers
      return static_cast<std::uint32_t>(c[0]) >= numberOfPoints ||
        static_cast<std::uint32_t>(c[1]) >= numberOfPoints ||
        static_cast<std::uint32_t>(c[2]) >= numberOfPoints;
    });
  found.TrianglesOutOfRange = outside.Count;
  found.FirstTriangleOutOfRange = outside.First;
  return outside.Count > 0 ? InputStatus::IndexOutOfRange : InputStatus::Good;
}
}

InputStatus CheckSurface(const Surface& input, int threads, CleaningStatistics& found)
{
  found.PointsRead = static_cast<std::int64_t>(input.Points.size());
  found.TrianglesRead = static_cast<std::int64_t>(input.Triangles.size());
  if (input.Triangles.size() > MaxTriangles ||
    input.Points.size() > std::numeric_limits<Index>::max())
  {
    return InputStatus::TooManyTriangles;
  }
  const InputStatus points = CheckPoints(input, threads, found);
  const InputStatus status =
    points == InputStatus::Good ? CheckTriangles(input, threads, found) : points;
  if (status == InputStatus::Good && input.Triangles.empty())
  {
    return input.Points.empty() ? InputStatus::Empty : InputStatus::NoTriangles;
  }
  return status;
}

namespace
{
/// How cleaning treats a triangle.
enum class Fate : std::uint8_t
{
  Kept,
  Repeated, ///< Two corners are equal: dropped.
  Flat      ///< No area: dropped unless it connects the surface.
};

/// Cleans an input that passed the checks.
class Cleaner
{
public:
  Cleaner(const Surface& input, int threads, CleanSurface& clean)
    : Input(input)
    , Threads(threads)
    , Clean(clean)
    , Representative(input.Points.size())
    , Fates(input.Triangles.size(), Fate::Kept)
  {
  }

  /// False if no triangle is left.
  bool Run(bool mergePoints)
  {
    this->FindRepresentatives(mergePoints);
    this->DropTriangles();
    if (this->Clean.Statistics.DroppedTriangles == this->Clean.Statistics.TrianglesRead)
    {
      return false;
    }
    this->NumberPoints();
    this->FillTriangles();
    this->FillPoints();
    return true;
  }

private:
  /// The corners as representative points.
  Triangle RepresentativeCorners(std::size_t t) const
  {
    const Triangle& c = this->Input.Triangles[t];
    return { this->Representative[c[0]], this->Representative[c[1]], this->Representative[c[2]] };
  }

  /// For each input point, whether a kept triangle uses it.
  std::vector<char> UsedPoints() const
  {
    std::vector<char> used(this->Representative.size(), 0);
    for (std::size_t t = 0; t < this->Fates.size(); ++t)
    {
      if (this->Fates[t] == Fate::Kept)
      {
        const Triangle& c = this->Input.Triangles[t];
        used[c[0]] = used[c[1]] = used[c[2]] = 1;
      }
    }
    return used;
  }

  void FindRepresentatives(bool mergePoints)
  {
    const std::vector<char> used = this->UsedPoints();
    ForEachId(this->Representative.size(), this->Threads,
      [&](std::size_t p)
      { this->Representative[p] = used[p] != 0 ? static_cast<Index>(p) : None; });
    if (mergePoints)
    {
      this->MergedPoints =
        MergeEqualPoints(this->Input.Points, this->Representative, this->Threads);
    }
  }

  void DropTriangles()
  {
    ForEachId(
      this->Fates.size(), this->Threads, [&](std::size_t t) { this->Fates[t] = this->FateOf(t); });
    const auto find = [&](const auto& isIt)
    {
      return FindAll(
        this->Fates.size(), this->Threads, [&](std::size_t t) { return isIt(this->Fates[t]); });
    };
    if (find([](Fate fate) { return fate == Fate::Flat; }).Count > 0)
    {
      this->KeepFlatOnesThatHoldTheSurface();
    }
    const Tally dropped = find([](Fate fate) { return fate != Fate::Kept; });
    this->Clean.Statistics.DroppedTriangles = dropped.Count;
    this->Clean.Statistics.FirstDroppedTriangle = dropped.First;
  }

  Fate FateOf(std::size_t t) const
  {
    const Triangle c = this->RepresentativeCorners(t);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
    {
      return Fate::Repeated;
    }
    const std::vector<Vector3>& p = this->Input.Points;
    return AreaVector(p[c[0]], p[c[1]], p[c[2]]).isZero(0.0) ? Fate::Flat : Fate::Kept;
  }

  /// A triangle without area that has neighbors at two or three edges closes the gap between them.
  void KeepFlatOnesThatHoldTheSurface()
  {
    std::vector<Triangle> triangles;
    std::vector<std::size_t> ids;
    for (std::size_t t = 0; t < this->Fates.size(); ++t)
    {
      if (this->Fates[t] != Fate::Repeated)
      {
        triangles.push_back(this->RepresentativeCorners(t));
        ids.push_back(t);
      }
    }
    const EdgeMatching matching(triangles, this->Representative.size(), this->Threads);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const Index* twins = matching.Twins().data() + 4 * i;
      const auto shared = std::count_if(twins, twins + 3, [](Index twin) { return twin != None; });
      Fate& fate = this->Fates[ids[i]];
      fate = fate == Fate::Flat && shared > 1 ? Fate::Kept : fate;
    }
  }

  /// Numbers the representative points in input order and counts them.
  void NumberPoints()
  {
    CleaningStatistics& found = this->Clean.Statistics;
    std::vector<Index>& number = this->Clean.PointOfInput;
    if (found.DroppedTriangles > 0)
    {
      this->ForgetPointsOfDroppedTriangles();
    }
    ReserveLarge(number, this->Representative.size());
    number.assign(this->Representative.size(), None);
    ReserveLarge(this->Clean.InputPoint, this->Representative.size());
    for (std::size_t p = 0; p < this->Representative.size(); ++p)
    {
      if (this->Representative[p] == static_cast<Index>(p))
      {
        number[p] = static_cast<Index>(this->Clean.InputPoint.size());
        this->Clean.InputPoint.push_back(this->Representative[p]);
      }
    }
    this->Clean.InputPointCount.assign(this->Clean.InputPoint.size(), 1);
    found.UnusedPoints =
      found.PointsRead - static_cast<std::int64_t>(this->Clean.InputPoint.size());
    for (std::size_t p = 0; p < this->Representative.size() && this->MergedPoints > 0; ++p)
    {
      if (this->Representative[p] != None && this->Representative[p] != static_cast<Index>(p))
      {
        number[p] = number[this->Representative[p]];
        ++this->Clean.InputPointCount[number[p]];
        ++found.MergedPoints;
        --found.UnusedPoints;
      }
    }
  }

  /// Points are kept if their representative is a corner of a kept triangle.
  void ForgetPointsOfDroppedTriangles()
  {
    std::vector<char> used(this->Representative.size(), 0);
    for (std::size_t t = 0; t < this->Fates.size(); ++t)
    {
      for (const Index corner : this->RepresentativeCorners(t))
      {
        used[corner] = this->Fates[t] == Fate::Kept ? 1 : used[corner];
      }
    }
    for (Index& point : this->Representative)
    {
      point = point == None || used[point] == 0 ? None : point;
    }
  }

  void FillTriangles()
  {
    const std::size_t count = this->Fates.size();
    std::vector<std::size_t> next = StartsOfBlocks(
      count, this->Threads, [&](std::size_t t) { return this->Fates[t] == Fate::Kept; });
    ReserveLarge(this->Clean.Surface.Triangles, next.back());
    ReserveLarge(this->Clean.InputTriangle, next.back());
    this->Clean.Surface.Triangles.resize(next.back());
    this->Clean.InputTriangle.resize(next.back());
    const std::vector<Index>& number = this->Clean.PointOfInput;
    ForEachBlock(count, this->Threads,
      [&](std::size_t block, std::size_t first, std::size_t last)
      {
        for (std::size_t t = first; t < last; ++t)
        {
          if (this->Fates[t] == Fate::Kept)
          {
            const Triangle& c = this->Input.Triangles[t];
            const std::size_t index = next[block]++;
            this->Clean.InputTriangle[index] = static_cast<Index>(t);
            this->Clean.Surface.Triangles[index] = { number[c[0]], number[c[1]], number[c[2]] };
          }
        }
      });
  }

  /// Moves the origin to the lower corner of the bounding box.
  void FillPoints()
  {
    const std::vector<Index>& ids = this->Clean.InputPoint;
    const std::vector<Vector3>& from = this->Input.Points;
    std::vector<Vector3> lows(NumberOfBlocks(ids.size()));
    ForEachBlock(ids.size(), this->Threads,
      [&](std::size_t block, std::size_t first, std::size_t last)
      {
        Vector3 low = from[ids[first]];
        for (std::size_t p = first; p < last; ++p)
        {
          low = low.cwiseMin(from[ids[p]]);
        }
        lows[block] = low;
      });
    this->Clean.Origin = lows[0];
    for (const Vector3& low : lows)
    {
      this->Clean.Origin = this->Clean.Origin.cwiseMin(low);
    }
    ReserveLarge(this->Clean.Surface.Points, ids.size());
    this->Clean.Surface.Points.resize(ids.size());
    ForEachId(ids.size(), this->Threads,
      [&](std::size_t p) { this->Clean.Surface.Points[p] = from[ids[p]] - this->Clean.Origin; });
  }

  const Surface& Input;
  int Threads;
  CleanSurface& Clean;
  LargeArray<Index> Representative; // of each input point; None if unused
  LargeArray<Fate> Fates;           // for each input triangle
  std::int64_t MergedPoints = 0;
};
}

CleanSurface Clean(const Surface& input, bool mergePoints, int threads)
{
  CleanSurface clean;
  clean.Status = CheckSurface(input, threads, clean.Statistics);
  if (clean.Status == InputStatus::Good && !Cleaner(input, threads, clean).Run(mergePoints))
  {
    clean.Status = InputStatus::NoTriangles;
  }
  return clean;
}
}
