// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bones.h
 * @brief The bones of the benchmark, cut out of one CT volume.
 */
#ifndef BoneDecimate_Testing_Bones_h
#define BoneDecimate_Testing_Bones_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

/// A box of the volume in mm from its first voxel: least and greatest x, y, z.
using Box = std::array<double, 6>;

/**
 * Bone surfaces at 226 HU, equal points merged, triangles without area gone.
 * The maxilla and the frontal bone are stand-ins for the thesis's meshes, which are not public: the largest component
 * in a box with one voxel of air around it. They are defined on the CT of Debian's package invesalius-examples.
 */
class Bones
{
public:
  /// @param volumeFile A MetaImage (.mhd, .mha) of Hounsfield values.
  explicit Bones(const std::string& volumeFile);

  vtkSmartPointer<vtkPolyData> Whole() const;
  vtkSmartPointer<vtkPolyData> LargestIn(const Box& box) const;

  static constexpr Box Maxilla = { 75, 180, 140, 222, 0, 70 };
  static constexpr Box FrontalBone = { 55, 200, 147.5, 222, 70, 150 };

private:
  std::string VolumeFile;
};

#endif
