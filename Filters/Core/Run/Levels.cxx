// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Levels.h"

#include "Base/Parallel.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Levels/CarriedPoint.h"
#include "Mesh/Checksum.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/SpatialOrder.h"
#include "Mesh/SurfaceAssembly.h"
#include "Proof/Measure/SurfaceDistance.h"
#include "Run/Input/LabelMapInput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::int64_t MaxSamplesOfMark = 200000;

std::uint64_t ConnectivityOf(const Surface& surface, int threads)
{
  Surface triangles;
  triangles.Triangles = surface.Triangles;
  return Checksum(triangles, threads);
}
}

LogStatus Levels::Open(const Surface& input, EditLog log, int threads, const RunInputs& inputs)
{
  const LabelMapSource* map = inputs.LabelMap;
  this->Stack.reset();
  CleanSurface clean = Clean(input, log.MergesPoints, threads);
  if (clean.Status != InputStatus::Good || Checksum(input, threads) != log.InputChecksum)
  {
    return LogStatus::OtherSurface;
  }
  if (CheckLabelMap(map, input, {}) == InputStatus::BadLabelMap)
  {
    return LogStatus::BadLabelMap;
  }
  SortAlongCurve(clean, threads); // the same numbers as in the run, see PrepareInput.cxx
  if (SplitIntoManifoldPatches(clean, threads, PatchLabels(clean, inputs.Labels, map)))
  {
    SortAlongCurve(clean, threads);
  }
  if (clean.Surface.Points.size() != static_cast<std::size_t>(log.Vertices))
  {
    return LogStatus::OtherSurface;
  }
  std::optional<LevelStack> stack = LevelStack::Build(clean.Surface.Triangles, log);
  const auto isTrue = [&](const LevelMark& mark)
  { return stack->TrianglesAt(mark.Collapses) == mark.Triangles; };
  if (!stack || !std::all_of(log.Marks.begin(), log.Marks.end(), isTrue))
  {
    return LogStatus::Contradictory;
  }
  this->Map = LabelMapSource();
  if (map != nullptr)
  {
    this->Map.Grid = map->Grid;
    this->Map.Values = map->Values;
    this->Map.OfTriangle = BoundaryLabelsOf(clean, *map);
    this->InputPairs = map->OfTriangle;
  }
  this->Changed.clear();
  this->Edits = std::move(log);
  this->Threads = threads;
  this->InputPoint = std::move(clean.InputPoint);
  this->InputTriangle = std::move(clean.InputTriangle);
  this->OriginalVertices = std::move(clean.ManifoldPatches.OriginalVertices);
  this->InputPoints = input.Points.size();
  this->Points = this->PointsOf(input);
  this->Triangles = std::move(clean.Surface.Triangles);
  this->Connectivity = ConnectivityOf(input, threads);
  this->Stack = std::move(stack);
  return LogStatus::Good;
}

//------------------------------------------------------------------------------
/// For each vertex of the cleaned input.
std::vector<Vector3> Levels::PointsOf(const Surface& input) const
{
  std::vector<Vector3> points(this->InputPoint.size());
  ForEachId(points.size(), this->Threads,
    [&](std::size_t v)
    {
      const Vector3& point = input.Points[static_cast<std::size_t>(this->InputPoint[v])];
      points[v] = this->Edits.IsSingle ? RoundedToSingle(point) : point;
    });
  return points;
}

//------------------------------------------------------------------------------
Index Levels::ByError(double error) const
{
  Index level = 0;
  for (const LevelMark& mark : this->Edits.Marks)
  {
    level = mark.Largest <= error ? mark.Collapses : level;
  }
  return level;
}

//------------------------------------------------------------------------------
std::optional<Level> Levels::AtOn(const Surface& other, Index collapses) const
{
  const auto isUsable = [](const Vector3& point) { return IsUsable(point); };
  if (other.Points.size() != this->InputPoints ||
    !std::all_of(other.Points.begin(), other.Points.end(), isUsable) ||
    ConnectivityOf(other, this->Threads) != this->Connectivity)
  {
    return {};
  }
  const std::vector<Vector3> points = this->PointsOf(other);
  const BoundingTree tree({ this->Points, this->Triangles }, this->Threads);
  const auto cornersIn = [this](const std::vector<Vector3>& all, Index triangle)
  {
    const Triangle& c = this->Triangles[static_cast<std::size_t>(triangle)];
    return std::array<Vector3, 3>{ all[static_cast<std::size_t>(c[0])],
      all[static_cast<std::size_t>(c[1])], all[static_cast<std::size_t>(c[2])] };
  };
  Level level = this->At(collapses);
  ForEachId(level.Vertices.size(), this->Threads,
    [&](std::size_t p)
    {
      const auto vertex = static_cast<std::size_t>(level.Vertices[p]);
      Vector3& point = level.Surface.Points[p];
      if (point == this->Points[vertex])
      {
        point = points[vertex];
        return;
      }
      const Index triangle = tree.FindNearest(point).Triangle;
      point = CarriedPoint(point, cornersIn(this->Points, triangle), cornersIn(points, triangle));
      point = this->Edits.IsSingle ? RoundedToSingle(point) : point;
    });
  return level;
}

//------------------------------------------------------------------------------
bool Levels::Mark(bool measure, const Monitor& monitor)
{
  this->Edits.Marks.clear();
  const Index last = this->NumberOfCollapses();
  for (double triangles = this->TrianglesAt(0); last > 0; triangles /= std::sqrt(2.0))
  {
    LevelMark mark;
    mark.Collapses = this->ByTriangles(static_cast<Index>(triangles));
    mark.Triangles = this->TrianglesAt(mark.Collapses);
    if (mark.Collapses > 0)
    {
      this->Edits.Marks.push_back(mark);
    }
    if (mark.Collapses == last)
    {
      break;
    }
  }
  if (!measure || this->Edits.Marks.empty())
  {
    return true;
  }
  const BoundingTree input({ this->Points, this->Triangles }, this->Threads);
  double done = 0.0;
  for (LevelMark& mark : this->Edits.Marks)
  {
    if (monitor && !monitor(done / static_cast<double>(this->Edits.Marks.size())))
    {
      return false;
    }
    this->MeasureMark(input, mark);
    done += 1.0;
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<BoundaryLabels> Levels::BoundaryLabelsAt(Index collapses) const
{
  std::vector<BoundaryLabels> pairs;
  if (!this->Map.OfTriangle.empty())
  {
    for (const Index face : this->Stack->FacesAt(collapses))
    {
      pairs.push_back(this->Map.OfTriangle[static_cast<std::size_t>(face)]);
    }
  }
  return pairs;
}

//------------------------------------------------------------------------------
std::vector<Index> Levels::InputTrianglesAt(Index collapses) const
{
  std::vector<Index> triangles = this->Stack->FacesAt(collapses);
  for (Index& triangle : triangles)
  {
    triangle = this->InputTriangle[static_cast<std::size_t>(triangle)];
  }
  return triangles;
}

//------------------------------------------------------------------------------
bool Levels::CompareVoxels(const Surface& input, const Monitor& monitor)
{
  this->Changed.clear();
  if (this->Map.Grid.Dimensions[0] == 0)
  {
    return true;
  }
  VoxelCheckSettings settings;
  settings.Grid = this->Map.Grid;
  settings.NumberOfLabels =
    this->Map.OfTriangle.empty() ? 2 : static_cast<Index>(this->Map.Values.size());
  settings.Threads = this->Threads;
  for (const LevelMark& mark : this->Edits.Marks)
  {
    const Surface level = this->At(mark.Collapses).Surface;
    const std::vector<BoundaryLabels> pairs = this->BoundaryLabelsAt(mark.Collapses);
    const VoxelChanges changes =
      bonedecimate::CompareVoxels({ input, this->InputPairs }, { level, pairs }, settings, monitor);
    if (!changes.IsDone)
    {
      this->Changed.clear();
      return false;
    }
    this->Changed.push_back(changes.Changed);
  }
  return true;
}

//------------------------------------------------------------------------------
void Levels::MeasureMark(const BoundingTree& input, LevelMark& mark) const
{
  const std::int64_t samples =
    std::min(MaxSamplesOfMark, 4 * static_cast<std::int64_t>(this->Triangles.size()));
  const Surface level = this->At(mark.Collapses).Surface;
  const BoundingTree tree(level, this->Threads);
  const DistanceStatistics to = MeasureDistance(level,
    PointDistances(level.Points, input, this->Threads, {}), input, samples, this->Threads, {});
  const DistanceStatistics from = MeasureDistance({ this->Points, this->Triangles },
    PointDistances(this->Points, tree, this->Threads, {}), tree, samples, this->Threads, {});
  mark.Largest = std::max(to.Maximum, from.Maximum);
  mark.Mean = std::max(to.Mean, from.Mean);
}

//------------------------------------------------------------------------------
Result RecordLevels(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, Levels& levels)
{
  constexpr double runAt = 0.5;
  constexpr double markedAt = 0.9;
  EditLog log;
  Options whole = options.WithoutPruning();
  whole.OutputPointsGrid = 0.0; // a log has no grid
  const Monitor all = [&monitor](double done) { return !monitor || monitor(done); };
  RunInputs recorded = inputs;
  recorded.Log = &log;
  Result run = Decimate(input, whole, PartOf(all, 0.0, runAt), recorded);
  levels = Levels();
  if (run.Report.Status == InputStatus::Good &&
    levels.Open(input, std::move(log), options.NumberOfThreads, inputs) == LogStatus::Good &&
    !(levels.Mark(options.MeasureDistances, PartOf(all, runAt, markedAt)) &&
      levels.CompareVoxels(input, PartOf(all, markedAt, 1.0))))
  {
    run.Report.Stop = StopReason::Aborted;
  }
  return run;
}
}
