// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothingFigures.h
 * @brief What smoothing did before the first edit.
 */
#ifndef BoneDecimate_Core_Figures_SmoothingFigures_h
#define BoneDecimate_Core_Figures_SmoothingFigures_h

#include <cstdint>

namespace bonedecimate
{
/// The smoothing before the first edit.
struct SmoothingFigures
{
  /// What is known of the segmentation that the surface comes from.
  enum class Source : int
  {
    NotRequested = 0,
    LabelMap, ///< A label map, named with the surface.
    Binary,   ///< Its points are the middles of grid edges: the surface of a binary segmentation.
    /// Its points lie on the edges of a grid, interpolated: left alone by the automatic smoothing.
    GrayLevel,
    Unknown ///< No grid was found.
  };
  Source From = Source::NotRequested; ///< If NotRequested, all other members are meaningless.
  double Bound = 0.0;           ///< mm, the largest displacement allowed; 0: nothing was smoothed.
  bool IsInVoxels = false;      ///< Thick slices: smoothed in voxel units, within octahedra.
  double Strength = 0.0;        ///< lambda of Smoothing/BoundedSolver.h
  double RmsDisplacement = 0.0; ///< mm
  double MaxDisplacement = 0.0; ///< mm
  double AngleBefore = 0.0;     ///< Degrees, mean angle between the normals of neighbors.
  double AngleAfter = 0.0;
  double AreaBefore = 0.0; ///< mm^2
  double AreaAfter = 0.0;
  double VolumeBefore = 0.0; ///< mm^3, of all closed components.
  double VolumeAfter = 0.0;
  std::int64_t SharpPoints = 0; ///< On edges that were kept because of FeatureAngle.
  std::int64_t LimitedPoints =
    0; ///< Whose bound was lowered, because triangles would intersect or turn over.
  std::int64_t Rounds = 0; ///< Rounds of lowering bounds.

  bool HasRun() const { return this->Bound > 0.0; }
};
}

#endif
