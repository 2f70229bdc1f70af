// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Smoothing.h"

#include "Base/Parallel.h"
#include "BoundedSolver.h"
#include "Mesh/SurfaceAssembly.h"
#include "NewCrossings.h"
#include "SharpEdges.h"
#include "SmoothingStrength.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
/// Fraction of the radius for the solver; rounding to the precision of the output needs the rest.
constexpr double RadiusOfSolver = 0.999;
/// Number of times that a radius is halved before it is set to 0.
constexpr int MaxHalvings = 6;
/// Rings of points around an intersection that are solved again.
constexpr int RingsAround = 4;
/// Fractions of the progress.
constexpr double GraphAt = 0.15;
constexpr double StrengthAt = 0.5;
constexpr double SolvedOnceAt = 0.65;
constexpr double SolvedAt = 0.8;
/// In median edge lengths: about two voxels for marching cubes of a binary volume.
constexpr double ScaleOfSharpEdges = 2.3;

/// mm, for each point the least of the radius, its limit and those of its neighbors.
std::vector<double> RadiiOf(
  const SmoothingInput& input, const SmoothingGraph& graph, const SmoothingSettings& settings)
{
  std::vector<double> radii(input.Surface.Points.size(), settings.Radius);
  if (input.Limits != nullptr)
  {
    ForEachId(radii.size(), settings.Threads,
      [&](std::size_t p)
      {
        double least = std::min(settings.Radius, (*input.Limits)[p]);
        graph.VisitNeighbors(static_cast<Index>(p),
          [&](Index neighbor) { least = std::min(least, (*input.Limits)[neighbor]); });
        radii[p] = std::max(0.0, least);
      });
  }
  return radii;
}

std::vector<double> Scaled(std::vector<double> radii, double factor)
{
  for (double& radius : radii)
  {
    radius *= factor;
  }
  return radii;
}

/// From millimeters to the units of displacements, in which edges are measured.
Eigen::Matrix3d ToUnits(const SmoothingInput& input, const SmoothingSettings& settings)
{
  if (!settings.InVoxels || input.Source == nullptr)
  {
    return Eigen::Matrix3d::Identity();
  }
  const VoxelGrid& grid = input.Source->Grid;
  const Vector3 unitsOfMillimeter = (0.5 * grid.Spacing).cwiseInverse();
  return unitsOfMillimeter.asDiagonal() * grid.InverseDirection();
}

class Smoother
{
public:
  Smoother(const SmoothingInput& input, const SmoothingSettings& settings)
    : Input(input)
    , Settings(settings)
    , Points(input.Surface.Points)
    , Graph(input.Surface,
        input.Source != nullptr ? input.Source->OfTriangle : std::vector<BoundaryLabels>(),
        ToUnits(input, settings), settings.Threads)
    , Radii(RadiiOf(input, this->Graph, settings))
    , Sets(this->Points, Scaled(this->Radii, RadiusOfSolver), input.Source, settings.InVoxels,
        settings.Threads)
    , Solver(this->Graph, this->Sets, this->Points, settings.Threads)
    , Displacements(this->Points.size(), Vector3::Zero())
    , MovedPoints(this->Points)
  {
  }

  /// False after an abort.
  bool Run(const Monitor& monitor)
  {
    bool shouldContinue = true;
    const Monitor watched = [&](double done)
    {
      shouldContinue = shouldContinue && (!monitor || monitor(done));
      return shouldContinue;
    };
    watched(GraphAt);
    this->Strength = this->Settings.Strength;
    bool isNear = false;
    if (shouldContinue && this->Strength == 0.0)
    {
      this->Strength = this->AutomaticStrength(PartOf(watched, GraphAt, StrengthAt));
      isNear = this->HasGridPoints();
    }
    shouldContinue =
      shouldContinue && this->Solve(isNear, PartOf(watched, StrengthAt, SolvedOnceAt));
    if (shouldContinue && this->FindSharp())
    {
      shouldContinue = this->Solve(false, PartOf(watched, SolvedOnceAt, SolvedAt));
    }
    if (shouldContinue)
    {
      ForEachId(this->Points.size(), this->Settings.Threads,
        [&](std::size_t p) { this->MovePoint(static_cast<Index>(p)); });
      this->RemoveCrossings(PartOf(watched, SolvedAt, 1.0), shouldContinue);
    }
    return shouldContinue;
  }

  SmoothedSurface Take()
  {
    SmoothedSurface smoothed;
    smoothed.Figures = CompareSmoothed(
      this->Input.Surface, this->MovedPoints, this->Graph.SmoothEdges(), this->Settings.Threads);
    smoothed.Figures.Bound = this->Settings.Radius;
    smoothed.Figures.IsInVoxels = this->Settings.InVoxels;
    smoothed.Figures.Strength = this->Strength;
    smoothed.Figures.SharpPoints = this->Graph.NumberOfSharpPoints();
    smoothed.Figures.LimitedPoints =
      std::count_if(this->Halvings.begin(), this->Halvings.end(), [](int n) { return n > 0; });
    smoothed.Figures.Rounds = this->Rounds;
    smoothed.Points = std::move(this->MovedPoints);
    return smoothed;
  }

private:
  bool HasGridPoints() const
  {
    return this->Input.Source != nullptr && !this->Input.Source->OfPoint.empty();
  }

  /// With grid points, leaves the displacements near the minimum.
  double AutomaticStrength(const Monitor& monitor)
  {
    if (!this->HasGridPoints())
    {
      return DefaultStrength;
    }
    return ChooseStrength(
      { this->Input.Surface, this->Graph, this->Sets, *this->Input.Source, this->Settings.Threads },
      this->Solver, monitor, this->Displacements);
  }

  /// False after an abort.
  bool Solve(bool isNear, const Monitor& monitor)
  {
    return this->Solver.Run(this->Strength, this->Solver.IterationsOf(this->Strength, isNear),
      monitor, this->Displacements);
  }

  /// Gives the points on sharp edges rows of their own.  @return Whether there are any.
  bool FindSharp()
  {
    if (!(this->Settings.FeatureAngle < 180.0))
    {
      return false;
    }
    std::vector<Vector3> solved(this->Points.size());
    ForEachId(solved.size(), this->Settings.Threads,
      [&](std::size_t p)
      { solved[p] = this->Points[p] + this->Sets.ToMillimeters(this->Displacements[p]); });
    const Eigen::Matrix3d toUnits = this->Sets.UnitsOfMillimeters();
    const SharpEdges sharp =
      FindSharpEdges(solved, this->Input.Surface.Triangles, this->Graph.SmoothEdges(),
        { this->Settings.FeatureAngle, ScaleOfSharpEdges * this->Graph.MedianLength(), toUnits,
          this->Settings.Threads });
    if (std::find(sharp.IsSharp.begin(), sharp.IsSharp.end(), 1) == sharp.IsSharp.end())
    {
      return false;
    }
    this->Graph.KeepSharp(this->Input.Surface, sharp, toUnits);
    this->Solver.ReadRows(this->Points);
    return true;
  }

  /// Where the point will be when it has been written.
  Vector3 Rounded(const Vector3& position) const
  {
    return this->Settings.Rounding.OfLocal(position, this->Settings.Origin);
  }

  /// Moves a point by its displacement, rounded and within its bound.
  void MovePoint(Index point)
  {
    constexpr int mostHalvings = 8;
    const Vector3& from = this->Points[point];
    Vector3 displacement = this->Sets.ToMillimeters(this->Displacements[point]);
    this->MovedPoints[point] = from;
    for (int i = 0; i < mostHalvings && displacement != Vector3::Zero(); ++i)
    {
      const Vector3 to = this->Rounded(from + displacement);
      const Vector3 moved = to - from;
      if (moved.norm() <= this->Radii[point] && this->Sets.KeepsToOctahedron(point, moved))
      {
        this->MovedPoints[point] = to;
        return;
      }
      displacement *= 0.5;
    }
  }

  void RemoveCrossings(const Monitor& monitor, const bool& shouldContinue)
  {
    // In octahedra every voxel keeps its label, so nothing passes through a wall.
    NewCrossings crossings(this->Input.Surface,
      this->HasGridPoints() ? NewCrossings::Times::End : NewCrossings::Times::All,
      this->Settings.Threads);
    std::vector<char> isMoved(this->Input.Surface.Triangles.size(), 1);
    std::vector<Index> found = crossings.Find(this->MovedPoints, isMoved, monitor);
    while (shouldContinue && !found.empty())
    {
      ++this->Rounds;
      const std::vector<Index> around = this->LowerRadii(found);
      this->Solver.RunSome(this->Strength, around, this->Displacements);
      for (const Index point : around)
      {
        this->MovePoint(point);
      }
      this->MarkTriangles(around, isMoved);
      found =
        crossings.Find(this->MovedPoints, isMoved, [&monitor](double) { return monitor(1.0); });
    }
  }

  /// Halves the radii of the corners of triangles.
  /// @return The points around them, ascending.
  std::vector<Index> LowerRadii(const std::vector<Index>& triangles)
  {
    this->Halvings.resize(this->Points.size(), 0);
    std::vector<Index> corners;
    for (const Index t : triangles)
    {
      const Triangle& c = this->Input.Surface.Triangles[t];
      corners.insert(corners.end(), c.begin(), c.end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const Index point : corners)
    {
      const double factor = this->Halvings[point]++ < MaxHalvings ? 0.5 : 0.0;
      this->Radii[point] *= factor;
      this->Sets.SetRadius(point, RadiusOfSolver * this->Radii[point]);
    }
    return this->WithRings(std::move(corners));
  }

  std::vector<Index> WithRings(std::vector<Index> points) const
  {
    for (int ring = 0; ring < RingsAround; ++ring)
    {
      for (std::size_t i = 0, end = points.size(); i < end; ++i)
      {
        this->Graph.VisitNeighbors(points[i], [&](Index neighbor) { points.push_back(neighbor); });
      }
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    return points;
  }

  void MarkTriangles(const std::vector<Index>& points, std::vector<char>& isMoved) const
  {
    ForEachId(isMoved.size(), this->Settings.Threads,
      [&](std::size_t t)
      {
        const Triangle& c = this->Input.Surface.Triangles[t];
        isMoved[t] =
          std::any_of(c.begin(), c.end(),
            [&](Index corner) { return std::binary_search(points.begin(), points.end(), corner); })
          ? 1
          : 0;
      });
  }

  const SmoothingInput& Input;
  const SmoothingSettings& Settings;
  const std::vector<Vector3>& Points;
  SmoothingGraph Graph;
  std::vector<double> Radii; // mm
  DisplacementSets Sets;
  BoundedSolver Solver;
  std::vector<Vector3> Displacements; // in units of the sets
  std::vector<Vector3> MovedPoints;   // mm
  std::vector<int> Halvings;          // of each point; empty: none
  double Strength = 0.0;
  int Rounds = 0;
};
}

SmoothedSurface Smooth(
  const SmoothingInput& input, const SmoothingSettings& settings, const Monitor& monitor)
{
  Smoother smoother(input, settings);
  if (smoother.Run(monitor))
  {
    return smoother.Take();
  }
  SmoothedSurface aborted;
  aborted.Points = input.Surface.Points;
  aborted.IsAborted = true;
  return aborted;
}
}
