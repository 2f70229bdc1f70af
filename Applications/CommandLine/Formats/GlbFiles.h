// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GlbFiles.h
 * @brief Binary glTF 2.0: written plain or compressed, read from any program.
 *
 *     node 0             millimeters -> meters, z up -> y up; in its extras the unit
 *       node 1, 2 ...    one for each label: name, material of its color; in its extras the label
 *
 * Plain, coordinates are single numbers in millimeters, as core glTF has them. Compressed, they are
 * whole numbers of 16 bits (KHR_mesh_quantization) in the codec of EXT_meshopt_compression;
 * translation and scale of the nodes are those of the grid (PointGrid.h), one for all nodes of a
 * file.
 *
 * Coordinates are multiples of a power of two, exact in single precision: what is read back, before
 * node 0, is what was written, bit for bit, in both forms. Compressed, triangles and points are in
 * an order that takes fewer bytes.
 *
 * Khronos Group, glTF 2.0; KHR_mesh_quantization; EXT_meshopt_compression.
 */
#ifndef BoneDecimate_Applications_GlbFiles_h
#define BoneDecimate_Applications_GlbFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <set>
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
constexpr const char* KhronosMeshoptExtension = "KHR_meshopt_compression"; // its later name
constexpr const char* QuantizationExtension = "KHR_mesh_quantization";
/// Matrix of node 0, by columns: axes of the surface in glTF, where y is up and lengths are meters.
constexpr std::array<double, 16> FrameMatrix = { 0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0,
  0, 0, 1 };
/// @}

/// @name Points in mm; those of a compressed file are on a grid. @throws
/// Failure(ExitCode::CouldNotWrite) @{
void WriteGlbFile(vtkPolyData* surface, const std::string& path);
void WriteCompressedGlbFile(vtkPolyData* surface, const std::string& path);
/// @}

/// Names of the arrays of the surface that a file has: colors, normals and texture coordinates of
/// points, and labels.
std::set<std::string> ArraysOfGlb(vtkPolyData* surface);

/// The meshes of the default scene with their transforms: in mm, with BoundaryLabels if it has
/// labels, if this program wrote the file; else in the unit of SetFileUnit() (FileUnit.h). @throws
/// Failure(ExitCode::InputRejected)
vtkSmartPointer<vtkPolyData> ReadGlbFile(
  const std::string& path, std::vector<std::string>& warnings);
}

#endif
