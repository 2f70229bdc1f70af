// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Volume.h
 * @brief Voxels and where they lie in the patient; nothing else of a file's header.
 */
#ifndef BoneDecimate_Applications_Volume_h
#define BoneDecimate_Applications_Volume_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
using Vector3 = std::array<double, 3>;

/// mm in the patient's LPS system. Steps need not be at right angles: a tilted gantry shears the
/// volume.
struct VolumeGeometry
{
  Vector3 Origin{ { 0.0, 0.0, 0.0 } }; ///< Center of the first voxel.
  std::array<Vector3, 3> Steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } }; ///< From a voxel to its neighbor along i, j and k.
};

/// Where each layer lies along k, in steps, ascending; empty: at 0, 1, 2 and so on.
using LayerPositions = std::vector<double>;

struct Volume
{
  /// One value a voxel; its own origin and spacing mean nothing. Field arrays: LabelFields.h.
  vtkSmartPointer<vtkImageData> Image;
  VolumeGeometry Geometry;
  LayerPositions Layers;
  std::string Problem; ///< Why there is no image; empty if there is one.
  std::string Note;    ///< What of the input was left aside, for the user; may be empty.
  std::string Remark;  ///< What was done as the user wants it, which is no warning; may be empty.
};

Volume RejectedVolume(const std::string& problem);

Vector3 Sum(const Vector3& a, const Vector3& b);
Vector3 Difference(const Vector3& a, const Vector3& b);
Vector3 Scaled(const Vector3& a, double factor);
double Dot(const Vector3& a, const Vector3& b);
Vector3 Cross(const Vector3& a, const Vector3& b);
double Length(const Vector3& a);

/// Whether two directions agree to a thousandth, to which headers round.
bool AreClose(const Vector3& a, const Vector3& b);

/// Least distance between neighboring layers, in steps.
double LeastDistance(const LayerPositions& layers);

/// Determinant of the steps; negative if they mirror the volume.
double Determinant(const VolumeGeometry& geometry);

/// What is wrong with it (not finite, a step of no length, steps in one plane), or an empty text.
std::string GeometryProblem(const VolumeGeometry& geometry);

/**
 * Whether so many voxels can be stored in a file of that size: what is announced is held against
 * what is there, so that a damaged header cannot ask for memory without end.
 * @return What is wrong, or an empty text.
 */
std::string SizeProblem(const std::array<std::int64_t, 3>& size, int bytesPerVoxel,
  std::uintmax_t bytesInFile, bool isCompressed);

/// Not filled.
vtkSmartPointer<vtkImageData> AllocateImage(
  const std::array<std::int64_t, 3>& size, int scalarType, int components = 1);
}

#endif
