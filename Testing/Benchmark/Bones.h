// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bones.h
 * @brief The bones of the benchmark: cut out of a CT, read from a file, or grown to a size.
 */
#ifndef BoneDecimate_Testing_Bones_h
#define BoneDecimate_Testing_Bones_h

#include "TriangleFile.h"

#include <array>
#include <string>

/// A box of the volume in mm from its first voxel: least and greatest x, y, z.
using Box = std::array<double, 6>;

/// Stand-ins for the thesis's meshes, which are not public, in the CT of Debian's package
/// invesalius-examples.
constexpr Box Maxilla = { 75, 180, 140, 222, 0, 70 };
constexpr Box FrontalBone = { 55, 200, 147.5, 222, 70, 150 };

/// Voxels of the volume: first and one past the last x, y, z.
using VoxelBox = std::array<int, 6>;
/// Part of the vault of the skull in the same CT.
constexpr VoxelBox Vault = { 150, 230, 60, 140, 50, 105 };

/// All with equal points merged and triangles without area gone, so that every contestant starts
/// from the same ones. The whole bone at 226 HU. @param volume A MetaImage of Hounsfield values.
Triangles WholeBone(const std::string& volume);
/// The largest component of the bone in a box with one voxel of air around it.
Triangles LargestIn(const std::string& volume, const Box& box);
/// The bone in a box of voxels as a label map has it: each voxel is bone or not, by the same
/// threshold. Most of its triangles have coplanar neighbors.
Triangles BinaryCrop(const std::string& volume, const VoxelBox& box);
/// A surface file that VTK reads: .ply .stl .obj .vtp .vtk
Triangles SurfaceFile(const std::string& file);
/// The specimen of Specimen.h, its size chosen so that it has about that many triangles (within 3
/// %).
Triangles GrownSpecimen(double triangles);

#endif
