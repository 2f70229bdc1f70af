// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Specimen.h
 * @brief A shape in patient coordinates, scanned on any grid: the surface must not depend on the
 * grid.
 */
#ifndef BoneDecimate_Testing_Specimen_h
#define BoneDecimate_Testing_Specimen_h

#include "Volume.h"

#include <array>
#include <cstddef>
#include <vector>

namespace bonedecimate::testing
{
using volume::Vector3;
using volume::VolumeGeometry;

/// HU at which the surface of the specimen lies.
constexpr double SurfaceValue = 226.0;

/// mm outside the specimen, an ellipsoid and a ball with no symmetry between them; negative inside.
double SpecimenDistance(const Vector3& p);

/// mm^3.
double SpecimenVolume();

/// Voxels in the order of the files: the first axis runs fastest.
struct Scan
{
  std::array<std::size_t, 3> Size{ { 0, 0, 0 } };
  VolumeGeometry Geometry;
  std::vector<short> Values;
};

/// Scans the specimen; HU fall by 150 a mm from the inside to the outside.
Scan ScanOf(const std::array<std::size_t, 3>& size, const VolumeGeometry& geometry);

/// Voxels of 0.8 x 0.9 x 1.3 mm along x, y and z.
Scan UprightScan();

/// Voxels of the same size, turned about an axis that is none of the three.
Scan TiltedScan();

/// Tilted, the second axis running backwards: a left-handed grid.
Scan MirroredScan();

/// Tilted, the slices shifted against each other as by a tilted gantry.
Scan ShearedScan();
}

#endif
