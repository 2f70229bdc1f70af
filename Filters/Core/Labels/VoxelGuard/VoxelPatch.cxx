// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelPatch.h"

#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Voxel centers near a triangle, at most one on each line along the axis that is most nearly its
/// normal.
class CentersNear
{
public:
  CentersNear(
    const FixedTriangle& corners, FixedBox box, double margin, const CenterLattice& lattice)
    : Margin(margin)
    , Lattice(lattice)
  {
    box.Grow(static_cast<std::int64_t>(std::ceil(margin * UnitsOfVoxel)) + 1);
    this->IsEmpty = !lattice.HasCenter(box);
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->FirstIndices[k] = lattice.AtOrAbove(k, box.Low[k]);
      this->Planes[k] = lattice.NumberOfPlanes(box, k);
      const std::int64_t first = lattice.Coordinate(k, this->FirstIndices[k]);
      for (std::size_t i = 0; i < 3; ++i)
      {
        this->Corners[i][static_cast<Eigen::Index>(k)] =
          static_cast<double>(corners[i][k] - first) / UnitsOfVoxel;
      }
    }
  }

  bool Any() const
  {
    const Vector3 normal =
      (this->Corners[1] - this->Corners[0]).cross(this->Corners[2] - this->Corners[0]);
    Eigen::Index d = 0;
    const double most = normal.cwiseAbs().maxCoeff(&d);
    if (this->IsEmpty || most == 0.0)
    {
      return !this->IsEmpty;
    }
    const Eigen::Index s = (d + 1) % 3;
    const Eigen::Index t = (d + 2) % 3;
    const double thickness = this->Margin * normal.norm() / most; // along d
    Vector3 center;
    for (std::int64_t j = 0; j < this->Planes[static_cast<std::size_t>(s)]; ++j)
    {
      for (std::int64_t k = 0; k < this->Planes[static_cast<std::size_t>(t)]; ++k)
      {
        center[s] = this->CoordinateOf(s, j);
        center[t] = this->CoordinateOf(t, k);
        const double height = this->Corners[0][d] -
          (normal[s] * (center[s] - this->Corners[0][s]) +
            normal[t] * (center[t] - this->Corners[0][t])) /
            normal[d];
        center[d] = this->NearestTo(d, height);
        if (std::abs(height - center[d]) <= thickness && this->IsNear(center))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  /// The coordinate of a plane relative to the first one.
  double CoordinateOf(Eigen::Index axis, std::int64_t plane) const
  {
    const auto k = static_cast<std::size_t>(axis);
    return this->Lattice.IsEven(k)
      ? static_cast<double>(plane)
      : static_cast<double>(this->Lattice.Coordinate(k, this->FirstIndices[k] + plane) -
          this->Lattice.Coordinate(k, this->FirstIndices[k])) /
        UnitsOfVoxel;
  }

  /// The plane that is nearest to a height.
  double NearestTo(Eigen::Index axis, double height) const
  {
    const auto k = static_cast<std::size_t>(axis);
    if (this->Lattice.IsEven(k))
    {
      return std::floor(height + 0.5);
    }
    double nearest = 0.0;
    for (std::int64_t plane = 1; plane < this->Planes[k]; ++plane)
    {
      const double at = this->CoordinateOf(axis, plane);
      nearest = std::abs(at - height) < std::abs(nearest - height) ? at : nearest;
    }
    return nearest;
  }

  bool IsNear(const Vector3& center) const
  {
    const double squared =
      NearestOnTriangle(center, this->Corners[0], this->Corners[1], this->Corners[2])
        .SquaredDistance;
    return squared < this->Margin * this->Margin;
  }

  double Margin;
  const CenterLattice& Lattice;
  bool IsEmpty = false;
  std::array<Vector3, 3> Corners;             // steps, from the first center near the triangle
  std::array<std::int64_t, 3> FirstIndices{}; // its index
  std::array<std::int64_t, 3> Planes{};
};

FixedBox BoxOf(const FixedTriangle& corners)
{
  FixedBox box(corners[0]);
  box.Add(corners[1]);
  box.Add(corners[2]);
  return box;
}
}

void VoxelPatch::Clear()
{
  this->Faces.clear();
  this->HasSeveralLabels = false;
  this->IsMirrored = false;
  this->NearOldRim.clear();
  this->NearNewRim.clear();
}

//------------------------------------------------------------------------------
void VoxelPatch::Add(const FixedTriangle& corners, const BoundaryLabels& labels, int count)
{
  this->Faces.push_back({ corners, BoxOf(corners), labels, count });
  this->HasSeveralLabels = this->HasSeveralLabels || labels != this->Faces.front().Labels;
}

void VoxelPatch::AddOld(const FixedTriangle& corners, const BoundaryLabels& labels)
{
  this->Add(corners, labels, 1);
}

void VoxelPatch::AddNew(const FixedTriangle& corners, const BoundaryLabels& labels)
{
  this->Add(corners, labels, -1);
}

//------------------------------------------------------------------------------
void VoxelPatch::AddOldRim(const FixedPoint& from, const FixedPoint& to, double margin)
{
  AddEdgesNear(from, to, margin, this->Lattice, this->NearOldRim);
}

//------------------------------------------------------------------------------
void VoxelPatch::AddNewRim(const FixedPoint& from, const FixedPoint& to, double margin)
{
  AddEdgesNear(from, to, margin, this->Lattice, this->NearNewRim);
}

//------------------------------------------------------------------------------
FixedBox VoxelPatch::Box() const
{
  FixedBox box = this->Faces.front().Box;
  for (const Face& face : this->Faces)
  {
    box.Add(face.Box);
  }
  return box;
}

//------------------------------------------------------------------------------
bool VoxelPatch::KeepsLabels(bool isOpen)
{
  if (this->Faces.empty())
  {
    return true;
  }
  const FixedBox box = this->Box();
  if (box.Size() > MaxPatch)
  {
    return false;
  }
  if (!isOpen)
  {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
    {
      longest = this->Lattice.NumberOfPlanes(box, k) > this->Lattice.NumberOfPlanes(box, longest)
        ? k
        : longest;
    }
    return !this->Lattice.HasCenter(box) || this->KeepsAlong(longest, box);
  }
  bool keeps = true;
  for (std::size_t octant = 0; octant < 8 && keeps; ++octant)
  {
    // 0, 1, 0, 2, 0, 1, 0, 2: every octant once, and back again
    this->Mirror(octant % 2 == 0 ? 0 : octant % 4 == 1 ? 1 : 2);
    const FixedBox mirrored = this->Box();
    keeps = this->KeepsAlong(0, mirrored) && this->KeepsAlong(1, mirrored) &&
      this->KeepsAlong(2, mirrored);
  }
  return keeps;
}

//------------------------------------------------------------------------------
/// Needed because neither the displacement of voxel centers nor layers with positions of their own
/// are symmetric.
void VoxelPatch::Mirror(std::size_t axis)
{
  this->IsMirrored = this->IsMirrored != (axis == 2);
  for (Face& face : this->Faces)
  {
    for (FixedPoint& corner : face.Corners)
    {
      corner[axis] = -corner[axis];
    }
    face.Box = BoxOf(face.Corners);
  }
}

//------------------------------------------------------------------------------
/// Begins in the middle, where rejected edits are most often wrong.
bool VoxelPatch::KeepsAlong(std::size_t axis, const FixedBox& box)
{
  const std::size_t s = (axis + 1) % 3;
  const std::size_t t = (axis + 2) % 3;
  const CenterLattice& lattice = this->Centers();
  const std::int64_t firstS = lattice.AtOrAbove(s, box.Low[s]);
  const std::int64_t firstT = lattice.AtOrAbove(t, box.Low[t]);
  const std::int64_t across = lattice.NumberOfPlanes(box, s);
  const std::int64_t count = across * lattice.NumberOfPlanes(box, t);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t at = (i + count / 2) % count;
    if (!this->KeepsColumn({ axis, firstS + at % across, firstT + at / across }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool VoxelPatch::KeepsColumn(const Column& column)
{
  this->Sums.clear();
  for (const Face& face : this->Faces)
  {
    const ColumnCrossing crossing = CrossColumn(face.Corners, face.Box, column, this->Centers());
    if (crossing.Sign != 0)
    {
      const int count = face.Sign * crossing.Sign;
      this->AddCrossing(crossing.Below, face.Labels[0], count);
      if (this->HasSeveralLabels)
      {
        this->AddCrossing(crossing.Below, face.Labels[1], -count);
      }
    }
  }
  return std::all_of(
    this->Sums.begin(), this->Sums.end(), [](const Sum& sum) { return sum.Total == 0; });
}

//------------------------------------------------------------------------------
/// A list: a column crosses few triangles.
void VoxelPatch::AddCrossing(std::int64_t below, Index label, int count)
{
  for (Sum& sum : this->Sums)
  {
    if (sum.Below == below && sum.Label == label)
    {
      sum.Total += count;
      return;
    }
  }
  this->Sums.push_back({ below, label, count });
}

//------------------------------------------------------------------------------
bool VoxelPatch::IsNearCenter(double margin) const
{
  return std::any_of(this->Faces.begin(), this->Faces.end(),
    [this, margin](const Face& face)
    { return face.Sign < 0 && CentersNear(face.Corners, face.Box, margin, this->Lattice).Any(); });
}

//------------------------------------------------------------------------------
bool VoxelPatch::IsRimNearOtherEdges() const
{
  const auto& old = this->NearOldRim;
  return std::any_of(this->NearNewRim.begin(), this->NearNewRim.end(),
    [&old](const GridEdge& edge) { return std::find(old.begin(), old.end(), edge) == old.end(); });
}
}
