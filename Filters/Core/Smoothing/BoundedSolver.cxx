// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundedSolver.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Upper limit of lambda along the long axes of thick slices.
constexpr double MaxLambda = 100.0;

double ConditionOf(const Vector3& strengths)
{
  return 1.0 + 4.0 * strengths.maxCoeff();
}

double MomentumOf(const Vector3& strengths)
{
  const double root = std::sqrt(ConditionOf(strengths));
  return (root - 1.0) / (root + 1.0);
}
}

BoundedSolver::BoundedSolver(const SmoothingGraph& graph, const DisplacementSets& sets,
  const std::vector<Vector3>& points, int threads)
  : Graph(graph)
  , Sets(sets)
  , Threads(threads)
  , InitialRows(points.size())
  , Extrapolated(points.size(), Vector3::Zero())
  , Rows(points.size())
  , ColumnBounds(points.size())
{
  this->ReadRows(points);
  ForEachId(points.size(), threads,
    [&](std::size_t p) { this->ColumnBounds[p] = graph.ColumnBound(static_cast<Index>(p)); });
}

//------------------------------------------------------------------------------
void BoundedSolver::ReadRows(const std::vector<Vector3>& points)
{
  const auto toUnits = [this](const Vector3& d) { return this->Sets.FromMillimeters(d); };
  ForEachId(points.size(), this->Threads,
    [&](std::size_t p)
    { this->InitialRows[p] = this->Graph.RowOfPositions(static_cast<Index>(p), points, toUnits); });
}

//------------------------------------------------------------------------------
Vector3 BoundedSolver::Strengths(double lambda) const
{
  const Vector3 ratios = this->Sets.UnitLengths() / this->Sets.UnitLengths().minCoeff();
  const double largest = std::max(MaxLambda, lambda);
  return (lambda * ratios.cwiseProduct(ratios)).cwiseMin(largest);
}

//------------------------------------------------------------------------------
int BoundedSolver::IterationsOf(double lambda, bool isNear) const
{
  const double root = std::sqrt(ConditionOf(this->Strengths(lambda)));
  return static_cast<int>(std::ceil((isNear ? 2.0 : 4.0) * root));
}

//------------------------------------------------------------------------------
void BoundedSolver::FillRow(Index point)
{
  this->Rows[point] = this->InitialRows[point] + this->Graph.Row(point, this->Extrapolated);
}

//------------------------------------------------------------------------------
void BoundedSolver::Step(
  Index point, const Vector3& strengths, double momentum, std::vector<Vector3>& displacements)
{
  Vector3& d = displacements[point];
  Vector3& y = this->Extrapolated[point];
  const Vector3 gradient = y + strengths.cwiseProduct(this->Graph.TransposedRow(point, this->Rows));
  const double step = 1.0 / (1.0 + strengths.maxCoeff() * this->ColumnBounds[point]);
  const Vector3 next = this->Sets.Project(point, y - step * gradient);
  y = next + momentum * (next - d);
  d = next;
}

//------------------------------------------------------------------------------
bool BoundedSolver::Run(
  double lambda, int iterations, const Monitor& monitor, std::vector<Vector3>& displacements)
{
  const Vector3 strengths = this->Strengths(lambda);
  const double momentum = MomentumOf(strengths);
  this->Extrapolated = displacements;
  for (int i = 0; i < iterations; ++i)
  {
    if (monitor && !monitor(static_cast<double>(i) / iterations))
    {
      return false;
    }
    ForEachId(displacements.size(), this->Threads,
      [&](std::size_t p) { this->FillRow(static_cast<Index>(p)); });
    ForEachId(displacements.size(), this->Threads,
      [&](std::size_t p)
      { this->Step(static_cast<Index>(p), strengths, momentum, displacements); });
  }
  return true;
}

//------------------------------------------------------------------------------
void BoundedSolver::RunSome(
  double lambda, const std::vector<Index>& points, std::vector<Vector3>& displacements)
{
  std::vector<Index> rows = points;
  for (const Index point : points)
  {
    this->Graph.VisitNeighbors(point, [&](Index neighbor) { rows.push_back(neighbor); });
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  this->Extrapolated = displacements;
  const Vector3 strengths = this->Strengths(lambda);
  const double momentum = MomentumOf(strengths);
  for (int i = this->IterationsOf(lambda, false); i > 0; --i)
  {
    for (const Index row : rows)
    {
      this->FillRow(row);
    }
    for (const Index point : points)
    {
      this->Step(point, strengths, momentum, displacements);
    }
  }
}
}
