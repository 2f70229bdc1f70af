// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelAttack.h"

#include "BruteForce.h"
#include "LabelVictims.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Victims.h"
#include "VoxelOracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double Margin = 1e-3;         // voxels
constexpr double Accuracy = 1e-6;       // voxels, of positions in voxels
constexpr std::size_t MostVoxels = 300; // that are counted exactly

struct LabelAttack
{
  Attack Run; // the surface as it was extracted
  LabelMap Map;
  LabelMapSource Source;
  std::vector<Index> Voxels; // index of the label of each voxel
  bool IsClosed = true;
  bool SmoothsOnly = false;
  bool CountsExactly = false;
  int OtherThreads = 0; // 0: not compared

  Index NumberOfLabels() const { return static_cast<Index>(this->Source.Values.size()); }
  double Spacing() const { return this->Map.Grid.Spacing.minCoeff(); }
};

void ExtractVictim(Random& random, LabelAttack& attack)
{
  attack.Map = AnyLabelMap(random);
  LabelSurfaceOptions options;
  options.Closed = random.Below(4) != 0;
  options.Threads = 1 + random.Below(2);
  attack.IsClosed = options.Closed;
  LabelSurfaces found =
    ExtractLabelSurfaces(MakeLabelImage(attack.Map.Labels.data(), attack.Map.Grid), options);
  attack.Run.Victim = std::move(found.Surface);
  attack.Source = std::move(found.Source);
  const std::vector<std::int64_t>& values = attack.Source.Values;
  for (const std::int32_t label : attack.Map.Labels)
  {
    attack.Voxels.push_back(
      static_cast<Index>(std::find(values.begin(), values.end(), label) - values.begin()));
  }
}

void ChooseSmoothing(Random& random, double spacing, Options& options)
{
  switch (random.Below(4))
  {
    case 0:
      break;
    case 1:
      options.Smoothing = spacing * std::pow(10.0, random.Between(-1.5, 0.3));
      break;
    default:
      options.AutomaticSmoothing = true;
  }
}

void ChooseEnd(Random& random, LabelAttack& attack)
{
  Options& options = attack.Run.Requested;
  if (random.Below(5) != 0)
  {
    options.MaximumError = attack.Spacing() * std::pow(10.0, random.Between(-1.3, 0.8));
  }
  if (random.Below(4) == 0)
  {
    options.TargetNumberOfTriangles =
      1 + random.Below(static_cast<Index>(attack.Run.Victim.Triangles.size()) + 1);
  }
  attack.SmoothsOnly = random.Below(6) == 0;
  if (attack.SmoothsOnly)
  {
    options.MaximumError =
      options.ProvesError() ? options.MaximumError : 0.0; // where mode Thesis ends
    options.TargetNumberOfTriangles = 0;
    options.TargetReduction = 0.0;
    options.TargetReductionIsExplicit = true;
  }
}

LabelAttack AnyAttack(std::uint64_t seed)
{
  Random random(seed);
  LabelAttack attack;
  ExtractVictim(random, attack);
  Options& options = attack.Run.Requested;
  options.Mode = static_cast<Mode>(random.Below(4));
  options.MeasureDistances = false;
  options.AllowLargeError = true;
  options.KeepVoxels = static_cast<KeepVoxels>(random.Below(3));
  options.IntersectionGuard = random.Below(4) != 0;
  options.NumberOfThreads = 1 + random.Below(3);
  options.OutputPointsPrecision =
    random.Below(2) == 0 ? PointsPrecision::Single : PointsPrecision::Double;
  ChooseSmoothing(random, attack.Spacing(), options);
  ChooseEnd(random, attack);
  if (random.Below(3) == 0 && !attack.Run.Victim.Triangles.empty())
  {
    attack.Run.Tolerances = AnyMap(random, attack.Run.Victim,
      options.MaximumError > 0.0 ? options.MaximumError : attack.Spacing());
    options.OutputPointsPrecision = PointsPrecision::Double; // a tolerance of 0 allows no rounding
  }
  attack.CountsExactly = random.Below(4) == 0;
  attack.OtherThreads = random.Below(3) == 0 ? 1 + options.NumberOfThreads % 3 : 0;
  attack.Run.IsRounded =
    options.OutputPointsPrecision == PointsPrecision::Single && random.Below(2) == 0;
  if (attack.Run.IsRounded)
  {
    RoundToSingle(attack.Run.Victim);
  }
  options.FeatureAngle = options.Smooths() ? random.Between(0.0, 180.0) : options.FeatureAngle;
  options.MinimumAngle = random.Below(4) == 0 ? random.Between(0.0, 40.0) : 0.0;
  options.EdgeLength = DrawEdgeLength(random, attack.Run.Victim);
  return attack;
}

Result RunOnce(const LabelAttack& attack, int threads)
{
  RunInputs inputs;
  inputs.Tolerances = attack.Run.Tolerances.empty() ? nullptr : &attack.Run.Tolerances;
  inputs.LabelMap = &attack.Source;
  Options options = attack.Run.Requested;
  options.NumberOfThreads = threads;
  return Decimate(attack.Run.Victim, options, {}, inputs);
}

using Corner = std::array<double, 3>;

/// The corners of each triangle, the least one first, in their order.
std::set<std::array<Corner, 3>> PositionsOf(const Surface& surface)
{
  std::set<std::array<Corner, 3>> all;
  for (const Triangle& t : surface.Triangles)
  {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3& p = surface.Points[static_cast<std::size_t>(t[k])];
      corners[k] = { p[0], p[1], p[2] };
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

std::string WhatConstraintsLost(const LabelAttack& attack, const Surface& result)
{
  const std::vector<double>& tolerances = attack.Run.Tolerances;
  Surface constrained;
  constrained.Points = attack.Run.Victim.Points;
  for (const Triangle& t : attack.Run.Victim.Triangles)
  {
    const bool isConstrained = !tolerances.empty() &&
      std::any_of(t.begin(), t.end(),
        [&](Index p) { return tolerances[static_cast<std::size_t>(p)] == 0.0; });
    if (isConstrained)
    {
      constrained.Triangles.push_back(t);
    }
  }
  const auto before = PositionsOf(constrained);
  const auto after = PositionsOf(result);
  return std::includes(after.begin(), after.end(), before.begin(), before.end())
    ? ""
    : "a triangle of a point with tolerance 0 changed";
}

std::string WhatLabelsLost(const LabelAttack& attack, const Result& result)
{
  const LabeledTriangles before = { attack.Run.Victim, attack.Source.OfTriangle };
  const LabeledTriangles after = { result.Surface, result.BoundaryLabels };
  if (result.BoundaryLabels.size() != result.Surface.Triangles.size())
  {
    return "there are not as many pairs of labels as triangles";
  }
  const Surface read = AsRead(result.Surface);
  if (attack.IsClosed && !AreWallsShared({ read, result.BoundaryLabels }, attack.NumberOfLabels()))
  {
    return "a wall is not shared";
  }
  for (Index label = 0; label < attack.NumberOfLabels(); ++label)
  {
    const std::string lost =
      WhatTopologyLost(SurfaceOfLabel(before, label), SurfaceOfLabel(after, label));
    if (!lost.empty())
    {
      return "label " + std::to_string(label) + " " + lost;
    }
  }
  return WhatTopologyLost(attack.Run.Victim, read);
}

std::string WhatCrosses(const LabelAttack& attack, const Result& result)
{
  const Options& options = attack.Run.Requested;
  const bool isGuarded = attack.SmoothsOnly || (options.IntersectionGuard && options.BoundsError());
  return isGuarded ? WhatPierces(attack.Run, attack.Run.Victim, result.Surface) : "";
}

bool KeepsVoxels(const LabelAttack& attack)
{
  const Options& options = attack.Run.Requested;
  return options.KeepVoxels == KeepVoxels::On ||
    (options.KeepVoxels == KeepVoxels::Automatic && options.MaximumError <= 0.5 * attack.Spacing());
}

/// Where no voxel may change.
std::string WhatVoxelsChanged(const LabelAttack& attack, const Result& result, Totals& totals)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int64_t wrong = CountWrongGridEdges(result.Surface, result.BoundaryLabels,
      attack.Source.Grid, { attack.Voxels, attack.Source.Background(), !attack.IsClosed }, axis);
    if (wrong > 0)
    {
      return std::to_string(wrong) + " edges of the grid along axis " + std::to_string(axis) +
        " do not cross the walls that they should";
    }
  }
  if (CountNearCenters(result.Surface, attack.Source.Grid, Margin - Accuracy) > 0)
  {
    return "a triangle is nearer to a voxel center than the margin";
  }
  if (!attack.IsClosed &&
    CountRimsNearLines(
      { result.Surface, result.BoundaryLabels }, attack.Source.Grid, Margin - Accuracy) > 0)
  {
    return "the boundary of the surface is nearer to a line of voxel centers than the margin";
  }
  if (attack.IsClosed && attack.CountsExactly && attack.Voxels.size() <= MostVoxels)
  {
    ++totals.ExactlyCounted;
    const std::int64_t wrong = CountWrongExactly({ result.Surface, result.BoundaryLabels },
      attack.Source.Grid, attack.Voxels, attack.Source.Background());
    return wrong > 0 ? std::to_string(wrong) + " voxels changed, counted exactly" : "";
  }
  return "";
}

/// The grid with so many voxels more on all sides.
VoxelGrid Padded(VoxelGrid grid, Index by)
{
  const VoxelGrid inner = grid;
  grid.Origin = grid.ToMillimeters(Vector3::Constant(-by));
  for (Index k = 0; inner.HasLayers() && k < inner.Dimensions[2] + 2 * by; ++k)
  {
    grid.Layers.resize(static_cast<std::size_t>(k) + 1);
    grid.Layers.back() = grid.Spacing[2] * (inner.StepsOf(k - by) - inner.StepsOf(-by));
  }
  for (Index& size : grid.Dimensions)
  {
    size += 2 * by;
  }
  return grid;
}

/// By how many voxels the grid has to be larger on all sides, so that the result lies in it.
Index VoxelsAround(const VoxelGrid& grid, const Result& result)
{
  constexpr double most = 200.0;
  double farthest = 0.0; // voxels
  for (const Vector3& p : result.Surface.Points)
  {
    const Vector3 voxel = grid.ToVoxels(p);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = grid.Dimensions[static_cast<std::size_t>(axis)] - 1.0;
      farthest = std::max({ farthest, -voxel[axis], voxel[axis] - last });
    }
  }
  return 2 + static_cast<Index>(std::min(farthest, most));
}

/// Where voxels may change: whether the report has as many as are counted here. Centers on triangles count either way.
std::string WhatReportMissed(const LabelAttack& attack, const Result& result)
{
  const Index background = attack.Source.Background();
  const VoxelGrid grid = Padded(attack.Source.Grid, VoxelsAround(attack.Source.Grid, result));
  const std::vector<Index> before =
    VoxelizeLabels(attack.Run.Victim, attack.Source.OfTriangle, grid, background, 1);
  const std::vector<Index> after =
    VoxelizeLabels(result.Surface, result.BoundaryLabels, grid, background, 0);
  std::int64_t changed = 0;
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    changed += before[i] != after[i] ? 1 : 0;
  }
  const std::int64_t reported = result.Report.Voxels.Changes.Changed;
  const std::int64_t unclear = CountNearCenters(result.Surface, attack.Source.Grid, Accuracy);
  return reported < changed - unclear || reported > changed + unclear ? std::to_string(reported) +
      " voxels changed by the report, " + std::to_string(changed) + " are counted"
                                                                      : "";
}

std::string WhatVoxelsBroke(const LabelAttack& attack, const Result& result, Totals& totals)
{
  const VoxelReport& report = result.Report.Voxels;
  const bool isGuarded = KeepsVoxels(attack);
  totals.Guarded += isGuarded ? 1 : 0;
  const bool mayDiffer = attack.SmoothsOnly && attack.Run.Requested.MaximumError == 0.0; // no edit
  if ((report.WereGuarded != isGuarded && !mayDiffer) || !report.WasChecked)
  {
    return "voxels were not guarded or not checked";
  }
  if (isGuarded || attack.SmoothsOnly)
  {
    const std::string broke = WhatVoxelsChanged(attack, result, totals);
    return !broke.empty()           ? broke
      : report.Changes.Changed != 0 ? "the report says that voxels changed"
                                    : "";
  }
  totals.ChangedVoxels += report.Changes.Changed;
  return attack.IsClosed ? WhatReportMissed(attack, result) : "";
}

std::string WhatThreadsChanged(const LabelAttack& attack, const Result& result)
{
  if (attack.OtherThreads == 0)
  {
    return "";
  }
  const Result other = RunOnce(attack, attack.OtherThreads);
  return SameBytes(result.Surface, other.Surface) && result.BoundaryLabels == other.BoundaryLabels
    ? ""
    : "the number of threads changes the result";
}

bool IsSmoothedTooFar(const LabelAttack& attack, const SmoothingFigures& figures)
{
  const Options& options = attack.Run.Requested;
  return figures.MaxDisplacement > figures.Bound ||
    (options.Smoothing > 0.0 && figures.Bound > options.Smoothing);
}

std::string WhatBroke(const LabelAttack& attack, Totals& totals)
{
  const Result result = RunOnce(attack, attack.Run.Requested.NumberOfThreads);
  ++totals.Runs;
  if (result.Report.Status != InputStatus::Good)
  {
    ++totals.Rejected;
    return {};
  }
  totals.Smoothed += result.Report.Smoothing.HasRun() ? 1 : 0;
  totals.TrianglesIn += static_cast<std::int64_t>(attack.Run.Victim.Triangles.size());
  totals.TrianglesOut += static_cast<std::int64_t>(result.Surface.Triangles.size());
  std::string broke = IsSmoothedTooFar(attack, result.Report.Smoothing)
    ? "a point was smoothed too far"
    : WhatLabelsLost(attack, result);
  const Options& options = attack.Run.Requested;
  const bool isBounded = options.MaximumError > 0.0 || !attack.Run.Tolerances.empty();
  if (broke.empty() && options.ProvesError() && isBounded)
  {
    broke = WhatBoundBroke(attack.Run, Cleaned(attack.Run.Victim), result.Surface, totals);
  }
  broke = broke.empty() ? WhatConstraintsLost(attack, result.Surface) : broke;
  broke = broke.empty() ? WhatCrosses(attack, result) : broke;
  broke = broke.empty() ? WhatVoxelsBroke(attack, result, totals) : broke;
  return broke.empty() ? WhatThreadsChanged(attack, result) : broke;
}

std::string DescribedWithMap(const LabelAttack& attack)
{
  const std::array<Index, 3>& size = attack.Map.Grid.Dimensions;
  return Described(attack.Run) + ", KeepVoxels " +
    std::to_string(static_cast<int>(attack.Run.Requested.KeepVoxels)) + ", " +
    std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
    " voxels, " + std::to_string(attack.NumberOfLabels()) + " labels, " +
    (attack.IsClosed ? "closed" : "open") + (attack.SmoothsOnly ? ", smoothed only" : "");
}
}

std::string AttackLabels(std::uint64_t seed, Totals& totals)
{
  const LabelAttack attack = AnyAttack(seed);
  const std::string broke = WhatBroke(attack, totals);
  return broke.empty() ? broke : broke + " (" + DescribedWithMap(attack) + ")";
}
}
