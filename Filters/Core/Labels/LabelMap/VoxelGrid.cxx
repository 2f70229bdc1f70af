// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelGrid.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr double RoundingOfAxes = 1e-6;
constexpr double MinDeterminant = 1e-3; // of unit vectors that are not in one plane

/// The step from a layer to the next one; beyond the ends the last one.
struct LayerGap
{
  std::int64_t Lower;
  double From; // steps, of that layer
  double Step;
};

LayerGap GapFrom(const VoxelGrid& grid, std::int64_t lower)
{
  const auto last = static_cast<std::int64_t>(grid.Layers.size()) - 1;
  if (last < 1)
  {
    return { 0, 0.0, 1.0 };
  }
  const std::int64_t k = std::clamp<std::int64_t>(lower, 0, last - 1);
  const double from = grid.Layers[static_cast<std::size_t>(k)] / grid.Spacing[2];
  const double to = grid.Layers[static_cast<std::size_t>(k) + 1] / grid.Spacing[2];
  return { k, from, to - from };
}

LayerGap GapAt(const VoxelGrid& grid, double steps)
{
  const auto above =
    std::upper_bound(grid.Layers.begin(), grid.Layers.end(), steps * grid.Spacing[2]);
  return GapFrom(grid, above - grid.Layers.begin() - 1);
}
}

Eigen::Matrix3d VoxelGrid::InverseDirection() const
{
  return this->IsOrthogonal() ? Eigen::Matrix3d(this->Direction.transpose())
                              : Eigen::Matrix3d(this->Direction.inverse());
}

Vector3 VoxelGrid::ShearedSteps(const Vector3& millimeters) const
{
  return (this->Direction.inverse() * (millimeters - this->Origin)).cwiseQuotient(this->Spacing);
}

//------------------------------------------------------------------------------
bool VoxelGrid::IsValid() const
{
  const bool isFinite =
    IsUsable(this->Origin) && IsUsable(this->Spacing) && this->Direction.allFinite();
  const Vector3 lengths = this->Direction.colwise().squaredNorm();
  if (!isFinite || !(this->Spacing.minCoeff() > 0.0) ||
    !((lengths - Vector3::Ones()).cwiseAbs().maxCoeff() <= RoundingOfAxes) ||
    !(std::abs(this->Direction.determinant()) >= MinDeterminant))
  {
    return false;
  }
  if (!this->HasLayers())
  {
    return true;
  }
  if (this->Layers.size() != static_cast<std::size_t>(this->Dimensions[2]) ||
    this->Layers[0] != 0.0 || !(this->Layers.back() <= MaxCoordinate))
  {
    return false;
  }
  const double least = (1.0 - RoundingOfAxes) * this->Spacing[2];
  return std::adjacent_find(this->Layers.begin(), this->Layers.end(),
           [least](double a, double b) { return !(b - a >= least); }) == this->Layers.end();
}

//------------------------------------------------------------------------------
Vector3 VoxelGrid::LayerNormal() const
{
  if (this->IsOrthogonal())
  {
    return this->Direction.col(2);
  }
  const Vector3 normal = this->Direction.col(0).cross(this->Direction.col(1)).normalized();
  return Dot(normal, this->Direction.col(2)) < 0.0 ? Vector3(-normal) : normal;
}

//------------------------------------------------------------------------------
double VoxelGrid::StepsOf(double layer) const
{
  if (!this->HasLayers())
  {
    return layer;
  }
  const LayerGap gap = GapFrom(*this, static_cast<std::int64_t>(std::floor(layer)));
  return gap.From + (layer - static_cast<double>(gap.Lower)) * gap.Step;
}

double VoxelGrid::LayerAt(double steps) const
{
  if (!this->HasLayers())
  {
    return steps;
  }
  const LayerGap gap = GapAt(*this, steps);
  return static_cast<double>(gap.Lower) + (steps - gap.From) / gap.Step;
}

//------------------------------------------------------------------------------
/// Corrects a first guess by the heights of layers, so that no rounding differs from that of
/// StepsOf().
std::int64_t VoxelGrid::FirstLayerAtOrAbove(double steps) const
{
  auto layer = static_cast<std::int64_t>(std::ceil(this->LayerAt(steps)));
  while (this->StepsOf(static_cast<double>(layer)) < steps)
  {
    ++layer;
  }
  while (this->StepsOf(static_cast<double>(layer - 1)) >= steps)
  {
    --layer;
  }
  return layer;
}

std::int64_t VoxelGrid::LastLayerAtOrBelow(double steps) const
{
  auto layer = static_cast<std::int64_t>(std::floor(this->LayerAt(steps)));
  while (this->StepsOf(static_cast<double>(layer)) > steps)
  {
    --layer;
  }
  while (this->StepsOf(static_cast<double>(layer + 1)) <= steps)
  {
    ++layer;
  }
  return layer;
}

//------------------------------------------------------------------------------
Vector3 VoxelGrid::MaxSpacing() const
{
  Vector3 largest = this->Spacing;
  for (std::size_t k = 1; k < this->Layers.size(); ++k)
  {
    largest[2] = std::max(largest[2], this->Layers[k] - this->Layers[k - 1]);
  }
  return largest;
}

double VoxelGrid::UnitVolume() const
{
  return this->IsOrthogonal() ? 1.0 : std::abs(this->Direction.determinant());
}

double VoxelGrid::UnitArea(int axis) const
{
  return this->IsOrthogonal()
    ? 1.0
    : this->Direction.col((axis + 1) % 3).cross(this->Direction.col((axis + 2) % 3)).norm();
}

//------------------------------------------------------------------------------
Vector3 HalfSidesAt(const VoxelGrid& grid, const GridPoint& point)
{
  Vector3 sides = grid.Spacing;
  if (grid.HasLayers())
  {
    const Index layer = point[2] >> 1; // the lower one
    const bool isInLayer = (point[2] & 1) == 0;
    sides[2] = isInLayer ? std::min(grid.DistanceAbove(layer - 1), grid.DistanceAbove(layer))
                         : grid.DistanceAbove(layer);
  }
  return 0.5 * sides;
}
}
