// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleFile.h
 * @brief Reads and writes plain triangles as binary PLY, for the programs of the benchmark.
 *
 * Independent of the core, so that the verifier has no code in common with it.
 */
#ifndef BoneDecimate_Testing_TriangleFile_h
#define BoneDecimate_Testing_TriangleFile_h

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct Triangles
{
  std::vector<std::array<double, 3>> Points; ///< mm
  std::vector<std::array<std::int32_t, 3>> Corners;
};

enum class Coordinates
{
  Single,
  Double
};

/// Little-endian binary PLY whose vertices begin with x, y, z and whose faces are triangles.
/// @throws std::runtime_error with the file's name and what is wrong with it.
Triangles ReadPly(const std::string& path);
void WritePly(const std::string& path, const Triangles& triangles, Coordinates coordinates);

#endif
