// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GlbFiles.h
 * @brief Binary glTF 2.0 with whole numbers as coordinates (KHR_mesh_quantization), compressed (EXT_meshopt_compression).
 *
 *     node 0             millimeters -> meters, z up -> y up; in its extras the unit
 *       node 1, 2 ...    one for each label: name, material of its color, translation and scale of the grid (PointGrid.h),
 *                        which is the same for all nodes; in its extras the label
 *
 * Decoded, a coordinate is translation + scale x whole number, which is exact in single precision: what is read back, before
 * node 0, is what was written, bit for bit. Triangles and points are in an order that compresses well.
 *
 * Khronos Group, glTF 2.0; KHR_mesh_quantization; EXT_meshopt_compression.
 */
#ifndef BoneDecimate_Applications_GlbFiles_h
#define BoneDecimate_Applications_GlbFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Point array of three bytes, red, green and blue: it becomes COLOR_0.
constexpr const char* VertexColorArray = "VertexColor";

/// @name Of a GLB file. @{
constexpr std::uint32_t GlbMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t JsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t BinaryChunk = 0x004E4942;
constexpr const char* MeshoptExtension = "EXT_meshopt_compression";
constexpr const char* QuantizationExtension = "KHR_mesh_quantization";
constexpr int UnsignedShort = 5123;
constexpr int UnsignedInt = 5125;
/// @}

/// Points in mm that are on a grid. @throws Failure(ExitCode::CouldNotWrite)
void WriteGlbFile(vtkPolyData* surface, const std::string& path);

/// A file of WriteGlbFile() in mm, with BoundaryLabels if it has labels. @throws Failure(ExitCode::InputRejected)
vtkSmartPointer<vtkPolyData> ReadGlbFile(
  const std::string& path, std::vector<std::string>& warnings);
}

#endif
