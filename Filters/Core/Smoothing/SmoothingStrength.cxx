// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothingStrength.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double TargetRatio = 0.7;
constexpr double RelativeAccuracy = 0.04;
constexpr double FirstStrength = 5.0;
constexpr int MaxSolves = 3;
constexpr int IterationsOfSolve = 10;
/// Exponent of the displacement as a power of lambda: the initial value and the least.
constexpr double FirstExponent = 0.35;
constexpr double MinExponent = 0.1;
constexpr double MinChange = 1.001;

/// The natural logarithm by its series: the same bits everywhere. x > 0.
double Logarithm(double x)
{
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent); // 0.5 to 1
  const double t = (mantissa - 0.75) / (mantissa + 0.75);
  double sum = 0.0;
  for (int power = 25; power > 0; power -= 2)
  {
    sum = 1.0 / power + t * t * sum;
  }
  constexpr double logarithmOf2 = 0.69314718055994530942;
  constexpr double logarithmOf3Quarters = -0.28768207245178092744;
  return exponent * logarithmOf2 + logarithmOf3Quarters + 2.0 * t * sum;
}

/// The exponential function, also the same bits everywhere.
double Exponential(double x)
{
  constexpr int halvings = 10;
  const double small = std::ldexp(x, -halvings);
  double sum = 1.0;
  for (int i = 12; i > 0; --i)
  {
    sum = 1.0 + small * sum / i;
  }
  for (int i = 0; i < halvings; ++i)
  {
    sum *= sum;
  }
  return sum;
}

int OddAxisOfEdge(const GridPoint& point) // -1: not on a grid edge
{
  int axis = -1;
  int count = 0;
  for (int k = 0; k < 3; ++k)
  {
    const bool isOdd = point[k] % 2 != 0;
    axis = isOdd ? k : axis;
    count += isOdd ? 1 : 0;
  }
  return count == 1 ? axis : -1;
}

struct Squares
{
  double Displacement = 0.0; // mm^2, along the normal
  double Rounding = 0.0;     // mm^2, expected

  Squares& operator+=(const Squares& other)
  {
    this->Displacement += other.Displacement;
    this->Rounding += other.Rounding;
    return *this;
  }
};

/// RMS of the displacement along the normal, divided by that of the rounding; 0 if there is no
/// point to measure.
double RatioToRounding(const StrengthProblem& problem, const std::vector<Vector3>& displacements)
{
  const std::vector<Vector3>& points = problem.Surface.Points;
  std::vector<Vector3> moved(points.size());
  ForEachId(points.size(), problem.Threads,
    [&](std::size_t p) { moved[p] = points[p] + problem.Sets.ToMillimeters(displacements[p]); });
  const std::vector<Vector3> normals = AreaNormals(moved, problem.Surface.Triangles);
  const VoxelGrid& grid = problem.Source.Grid;
  const Squares sum = SumOverBlocks(points.size(), problem.Threads,
    [&](std::size_t first, std::size_t last)
    {
      Squares squares;
      for (std::size_t p = first; p < last; ++p)
      {
        const int axis = OddAxisOfEdge(problem.Source.OfPoint[p]);
        const double length = normals[p].norm();
        const auto point = static_cast<Index>(p);
        if (axis >= 0 && length > 0.0 && problem.Sets.Radius(point) > 0.0 &&
          problem.Graph.Kind(point) == CurveKind::Interior)
        {
          const Vector3 n = normals[p] / length;
          const double along = Dot(n, moved[p] - points[p]);
          const double half = HalfSidesAt(grid, problem.Source.OfPoint[p])[axis];
          const double edge = half * Dot(n, grid.Direction.col(axis));
          squares += { along * along, edge * edge / 3.0 };
        }
      }
      return squares;
    });
  return sum.Rounding > 0.0 ? std::sqrt(sum.Displacement / sum.Rounding) : 0.0;
}

struct Trial
{
  double LogStrength = 0.0;
  double LogRatio = 0.0;
};

/// The exponent of the displacement as a power of lambda.
double ExponentOf(const std::vector<Trial>& trials)
{
  if (trials.size() < 2)
  {
    return FirstExponent;
  }
  const Trial& last = trials.back();
  const Trial& before = trials[trials.size() - 2];
  const double rise = last.LogRatio - before.LogRatio;
  const double run = last.LogStrength - before.LogStrength;
  return std::abs(rise) <= MinChange - 1.0 || run == 0.0 ? FirstExponent
                                                         : std::clamp(rise / run, MinExponent, 1.0);
}
}

double ChooseStrength(const StrengthProblem& problem, BoundedSolver& solver, const Monitor& monitor,
  std::vector<Vector3>& displacements)
{
  double strength = FirstStrength;
  std::vector<Trial> trials;
  bool isGood = false;
  for (int i = 0; i < MaxSolves && !isGood; ++i)
  {
    const Monitor part = monitor
      ? PartOf(monitor, static_cast<double>(i) / MaxSolves, (i + 1.0) / MaxSolves)
      : Monitor();
    if (!solver.Run(strength, IterationsOfSolve, part, displacements))
    {
      return strength;
    }
    const double ratio = RatioToRounding(problem, displacements);
    if (ratio == 0.0)
    {
      return DefaultStrength;
    }
    isGood = std::abs(ratio / TargetRatio - 1.0) < RelativeAccuracy;
    if (!isGood)
    {
      trials.push_back({ Logarithm(strength), Logarithm(ratio) });
      const double step = (Logarithm(TargetRatio) - trials.back().LogRatio) / ExponentOf(trials);
      const double most = Logarithm(MaxStrength / MinStrength);
      strength =
        std::clamp(strength * Exponential(std::clamp(step, -most, most)), MinStrength, MaxStrength);
    }
  }
  return strength;
}
}
