// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshoptStreams.h
 * @brief Corners and points of a part, compressed by meshoptimizer.
 */
#ifndef BoneDecimate_Applications_MeshoptStreams_h
#define BoneDecimate_Applications_MeshoptStreams_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bonedecimate
{
/// The bytes of all points of a part, as many for each.
struct PointStream
{
  std::string Bytes;
  std::size_t Stride = 4; ///< A multiple of four.
};

struct CompressedPart
{
  std::string Indices;              ///< Mode TRIANGLES of EXT_meshopt_compression.
  std::vector<std::string> Streams; ///< Mode ATTRIBUTES, as many as were given.
};

/// Compresses in the order of triangles and points that takes the fewest bytes: one of
/// meshoptimizer or the given one.
/// @param corners Three for each triangle. @param streams At least one.
CompressedPart Compress(
  const std::vector<std::uint32_t>& corners, const std::vector<PointStream>& streams);

/// What a file says of a compressed buffer view.
struct MeshoptView
{
  std::size_t Count = 0;
  std::size_t Stride = 0;
  std::string Mode;   ///< ATTRIBUTES, TRIANGLES or INDICES
  std::string Filter; ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL
};

/// Decodes count x stride bytes. @return What is wrong, a part of a sentence; empty: nothing.
std::string DecodeView(std::string_view bytes, const MeshoptView& view, std::string& decoded);
}

#endif
