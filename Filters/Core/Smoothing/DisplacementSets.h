// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DisplacementSets.h
 * @brief For each point the convex set of its allowed displacements: a ball, and an octahedron if
 * its grid point is known.
 *
 *     ball:        |d| <= r
 *     octahedron:  sum of |x0 + d - c| / h over the axes <= n - slack
 *                  h: half the side of a voxel, n: odd coordinates
 *
 * VoxelGrid.h says why points in octahedra keep the label of every voxel. The slack keeps triangles
 * away from voxel centers: 4e-3 half voxels give 1.1e-3 voxels.
 *
 * Displacements are along the axes of the grid, in units of the set: millimeters, or half voxels
 * for thick slices, where the octahedron alone limits points that have one.
 *
 * The sets contain 0. In millimeters a point is projected onto the ball, then onto the octahedron:
 * a projection onto a convex set that contains 0 does not lengthen, so the point stays in the ball.
 * In half voxels it is projected onto the octahedron, then shortened to the ball, which keeps it in
 * the octahedron. Sheared grids use this order, too, because a projection along their axes may
 * lengthen. The radius of the ball is always in millimeters.
 */
#ifndef BoneDecimate_Core_Smoothing_DisplacementSets_h
#define BoneDecimate_Core_Smoothing_DisplacementSets_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"

#include <cmath>
#include <vector>

namespace bonedecimate
{
class DisplacementSets
{
public:
  /// @param points mm.
  /// @param radii mm, of each point; 0: it does not move.
  /// @param source With OfPoint: octahedra; null or without: only balls. Its grid has the same
  ///   origin as the points.
  /// @param inVoxels Units of half voxels along each axis. Only with a source.
  DisplacementSets(const std::vector<Vector3>& points, std::vector<double> radii,
    const LabelMapSource* source, bool inVoxels, int threads);

  Vector3 Project(Index point, const Vector3& displacement) const
  {
    if (!(this->Radii[point] > 0.0))
    {
      return Vector3::Zero();
    }
    if (this->Octahedra.empty())
    {
      return this->ShortenedToBall(point, displacement);
    }
    return this->InVoxels || this->IsSheared
      ? this->ShortenedToBall(point, this->OntoOctahedron(point, displacement))
      : this->OntoOctahedron(point, this->ShortenedToBall(point, displacement));
  }

  /// Whether a displacement in mm stays in the octahedron, with an eighth of its slack for
  /// rounding; true without octahedra.
  bool KeepsToOctahedron(Index point, const Vector3& millimeters) const;

  Vector3 ToMillimeters(const Vector3& displacement) const
  {
    return this->Axes * this->Unit.cwiseProduct(displacement);
  }
  Vector3 FromMillimeters(const Vector3& millimeters) const
  {
    return this->InMillimetersAlongAxes(millimeters).cwiseQuotient(this->Unit);
  }
  /// FromMillimeters as a matrix.
  Eigen::Matrix3d UnitsOfMillimeters() const
  {
    return this->Unit.cwiseInverse().asDiagonal() * this->InverseAxes;
  }

  double Radius(Index point) const { return this->Radii[point]; } ///< mm
  void SetRadius(Index point, double millimeters) { this->Radii[point] = millimeters; }
  /// mm along each axis of one unit.
  const Vector3& UnitLengths() const { return this->Unit; }

private:
  struct Octahedron
  {
    Vector3 FromCenter; // of the point, units
    double Radius;      // half voxels, without slack
  };
  void AddOctahedra(const std::vector<Vector3>& points, const LabelMapSource& source, int threads);
  Vector3 ShortenedToBall(Index point, const Vector3& displacement) const
  {
    const double radius = this->Radii[point];
    const double squared = this->IsSheared ? this->ToMillimeters(displacement).squaredNorm()
                                           : this->Unit.cwiseProduct(displacement).squaredNorm();
    return squared <= radius * radius ? displacement
                                      : Vector3(radius / std::sqrt(squared) * displacement);
  }
  Vector3 OntoOctahedron(Index point, const Vector3& displacement) const
  {
    const Octahedron& octahedron = this->Octahedra[point];
    const Vector3 from = octahedron.FromCenter + displacement;
    return Dot(this->HalfVoxelsPerUnitAt(point), from.cwiseAbs()) <= octahedron.Radius
      ? displacement // bit for bit
      : this->OntoFace(point, from);
  }
  /// Projects a position outside of the octahedron, relative to its center, onto the nearest face.
  Vector3 OntoFace(Index point, const Vector3& from) const;

  Vector3 HalfVoxelsPerUnitAt(std::size_t point) const
  {
    return this->HalfVoxelsAlongThird.empty()
      ? this->HalfVoxelsPerUnit
      : Vector3(this->HalfVoxelsPerUnit[0], this->HalfVoxelsPerUnit[1],
          this->HalfVoxelsAlongThird[point]);
  }
  Vector3 InMillimetersAlongAxes(const Vector3& millimeters) const
  {
    return this->IsSheared ? Vector3(this->InverseAxes * millimeters)
                           : Vector3(this->Axes.transpose() * millimeters);
  }

  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d InverseAxes = Eigen::Matrix3d::Identity();
  bool IsSheared = false;
  Vector3 Unit = Vector3::Ones();              // mm
  Vector3 HalfVoxelsPerUnit = Vector3::Zero(); // with octahedra
  std::vector<double> HalfVoxelsAlongThird; // of each point, where the distance of layers changes
  bool InVoxels = false;
  std::vector<double> Radii; // mm
  std::vector<Octahedron> Octahedra;
};
}

#endif
