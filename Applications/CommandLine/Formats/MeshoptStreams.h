// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshoptStreams.h
 * @brief Corners and points of a part, compressed by meshoptimizer.
 */
#ifndef BoneDecimate_Applications_MeshoptStreams_h
#define BoneDecimate_Applications_MeshoptStreams_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
using PositionStream =
  std::array<std::uint16_t, 4>; ///< x, y, z and nothing: glTF wants multiples of four bytes.
using ColorStream = std::array<std::uint8_t, 4>;

struct CompressedPart
{
  std::size_t NumberOfPoints = 0;
  std::size_t NumberOfCorners = 0;
  std::array<std::uint16_t, 3> Least = {}; ///< Of the positions, by axis.
  std::array<std::uint16_t, 3> Most = {};
  std::string Indices;   ///< Mode TRIANGLES of EXT_meshopt_compression.
  std::string Positions; ///< Mode ATTRIBUTES, as the colors.
  std::string Colors;    ///< Empty: none.
};

/// In the order of triangles and points that takes the fewest bytes among those of meshoptimizer and the given one.
/// @param corners Three for each triangle. @param colors Empty: none.
CompressedPart Compress(const std::vector<std::uint32_t>& corners,
  const std::vector<PositionStream>& positions, const std::vector<ColorStream>& colors);

/// @name The other way. @return False if the bytes are damaged. @{
bool DecodeCorners(
  const std::string& bytes, std::size_t count, std::vector<std::uint32_t>& corners);
bool DecodePositions(
  const std::string& bytes, std::size_t count, std::vector<PositionStream>& positions);
/// @}
}

#endif
