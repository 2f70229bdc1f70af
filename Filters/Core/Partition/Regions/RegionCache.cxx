// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionCache.h"

#include "Base/Parallel.h"
#include "Mesh/Checksum.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/Statistics.h"
#include "Mesh/SurfaceAssembly.h"
#include "Options/OptionTable.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace bonedecimate
{
namespace
{
/// Bit for bit, so that -0 is not 0 and NaN is itself.
template <typename Value>
bool AreSame(const std::vector<Value>& a, const std::vector<Value>& b, int threads)
{
  std::atomic<bool> same{ a.size() == b.size() };
  const auto* first = reinterpret_cast<const char*>(a.data());
  const auto* second = reinterpret_cast<const char*>(b.data());
  ForEachBlock(same ? a.size() : 0, threads,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      const std::size_t at = begin * sizeof(Value);
      if (std::memcmp(first + at, second + at, (end - begin) * sizeof(Value)) != 0)
      {
        same = false;
      }
    });
  return same;
}

/// No result depends on the number of threads.
bool AreSame(const Options& a, const Options& b)
{
  return std::all_of(OptionTable().begin(), OptionTable().end(),
    [&](const OptionInfo& info)
    { return info.Name == "NumberOfThreads" || GetOption(a, info) == GetOption(b, info); });
}

void CountNonManifold(const EdgeMatching& matching, CleanSurface& clean)
{
  const Rings rings = matching.FindRings();
  CleaningStatistics& found = clean.Statistics;
  for (std::size_t v = 0; v < rings.Constraints.size(); ++v)
  {
    if (rings.Constraints[v] == VertexConstraint::NonManifold)
    {
      const std::int64_t id = clean.InputPoint[v];
      found.FirstNonManifoldPoint =
        found.NonManifoldPoints++ == 0 ? id : std::min(found.FirstNonManifoldPoint, id);
    }
  }
}

template <typename Value>
std::size_t BytesOf(const std::vector<Value>& values)
{
  return values.capacity() * sizeof(Value);
}

std::size_t BytesOf(const Surface& surface)
{
  return BytesOf(surface.Points) + BytesOf(surface.Triangles);
}

std::size_t BytesOf(const WholeSurface& whole)
{
  const CleanSurface& clean = whole.Cleaned;
  return BytesOf(clean.Surface) + BytesOf(clean.InputPoint) + BytesOf(clean.InputPointCount) +
    BytesOf(clean.InputTriangle) + BytesOf(clean.PointOfInput) +
    BytesOf(whole.Components.OfTriangle) + BytesOf(whole.Extents);
}

std::size_t BytesOf(const RegionPart& part)
{
  const Result& result = part.Result;
  const SurfaceOrigins& origins = result.Origins;
  return BytesOf(part.Covered.Triangles) + BytesOf(part.Covered.Points) +
    BytesOf(part.Covered.Tolerances) + BytesOf(part.Surface) + BytesOf(part.Points) +
    BytesOf(part.Triangles) + BytesOf(part.Tolerances) + BytesOf(part.Labels.OfTriangle) +
    BytesOf(part.OldTriangle) + BytesOf(part.OldPoint) + BytesOf(result.Surface) +
    BytesOf(result.Distance) + BytesOf(result.RunningError) + BytesOf(result.PointCount) +
    BytesOf(result.ErrorBound) + BytesOf(origins.NearestTriangle) + BytesOf(origins.Barycentric) +
    BytesOf(origins.NearestPoint) + BytesOf(origins.TriangleAtCentroid) +
    BytesOf(origins.OutputPoint);
}
}

WholeSurface PrepareWhole(const Surface& input, bool mergePoints, int threads)
{
  WholeSurface whole;
  whole.Cleaned = Clean(input, mergePoints, threads);
  const Surface& surface = whole.Cleaned.Surface;
  if (whole.Cleaned.Status != InputStatus::Good)
  {
    return whole;
  }
  const EdgeMatching matching(surface.Triangles, surface.Points.size(), threads);
  CountNonManifold(matching, whole.Cleaned);
  whole.Components = ComponentsAsParts(surface);
  whole.Extents = MeasureParts(surface.Points, surface.Triangles, whole.Components);
  const SurfaceCounts counts = { static_cast<std::int64_t>(surface.Points.size()),
    whole.Components.Count, matching.CountEdges() };
  whole.Statistics = Describe(surface, counts, threads);
  whole.Checksum = Checksum(input, threads);
  whole.IsSingle = std::all_of(input.Points.begin(), input.Points.end(),
    [](const Vector3& p) { return RoundedToSingle(p) == p; });
  return whole;
}

//------------------------------------------------------------------------------
bool RegionCache::BeginRun()
{
  const std::lock_guard<std::mutex> lock(this->State);
  const bool isFree = !this->IsInUse;
  this->IsInUse = true;
  return isFree;
}

void RegionCache::EndRun()
{
  const std::lock_guard<std::mutex> lock(this->State);
  this->IsInUse = false;
  if (this->IsToBeReleased)
  {
    this->Kept = {};
    this->IsToBeReleased = false;
  }
  this->KeptBytes = this->MeasureBytes();
}

void RegionCache::Release()
{
  const std::lock_guard<std::mutex> lock(this->State);
  this->IsToBeReleased = this->IsInUse;
  if (!this->IsInUse)
  {
    this->Kept = {};
    this->KeptBytes = 0;
  }
}

std::size_t RegionCache::Bytes() const
{
  const std::lock_guard<std::mutex> lock(this->State);
  return this->KeptBytes;
}

std::size_t RegionCache::MeasureBytes() const
{
  std::size_t bytes = BytesOf(this->Kept.Input) + BytesOf(this->Kept.Labels.OfTriangle) +
    (this->Kept.Prepared ? BytesOf(*this->Kept.Prepared) : 0);
  for (const Entry& entry : this->Kept.Entries)
  {
    bytes += BytesOf(*entry.Part);
  }
  return bytes;
}

//------------------------------------------------------------------------------
const WholeSurface& RegionCache::Whole(
  const Surface& input, const Labels* labels, bool mergePoints, int threads)
{
  Contents& kept = this->Kept;
  const bool isKept = kept.Prepared && kept.MergesPoints == mergePoints &&
    AreSame(kept.Input.Points, input.Points, threads) &&
    AreSame(kept.Input.Triangles, input.Triangles, threads);
  if (!isKept)
  {
    kept = {};
    kept.Input = input;
    kept.MergesPoints = mergePoints;
    kept.Prepared = std::make_unique<WholeSurface>(PrepareWhole(input, mergePoints, threads));
  }
  const Labels none;
  const Labels& given = labels != nullptr ? *labels : none;
  if (kept.Labels.Names != given.Names || kept.Labels.OfTriangle != given.OfTriangle)
  {
    kept.Entries.clear();
    kept.Labels = given;
  }
  return *kept.Prepared;
}

//------------------------------------------------------------------------------
std::shared_ptr<const RegionPart> RegionCache::Find(
  const Region& region, const Options& options, bool inputIsSingle)
{
  std::vector<Entry>& entries = this->Kept.Entries;
  const auto found = std::find_if(entries.begin(), entries.end(),
    [&](const Entry& entry)
    {
      return entry.Part->Covered == region && entry.InputIsSingle == inputIsSingle &&
        AreSame(entry.RunOptions, options);
    });
  if (found == entries.end())
  {
    return nullptr;
  }
  std::rotate(found, found + 1, entries.end());
  return entries.back().Part;
}

//------------------------------------------------------------------------------
void RegionCache::Keep(
  const std::shared_ptr<const RegionPart>& part, const Options& options, bool inputIsSingle)
{
  std::vector<Entry>& entries = this->Kept.Entries;
  entries.push_back({ part, options, inputIsSingle });
  std::size_t triangles = 0;
  const auto last = std::find_if(entries.rbegin(), entries.rend(),
    [&](const Entry& entry)
    {
      triangles += entry.Part->Triangles.size();
      return triangles > this->Kept.Input.Triangles.size();
    });
  entries.erase(entries.begin(), last.base());
}
}
