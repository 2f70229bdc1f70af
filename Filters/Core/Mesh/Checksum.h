// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checksum.h
 * @brief Checksums of the points and triangles of an input, and of a result.
 *
 * Checksum() of an input is FNV-1a over 64-bit words instead of bytes. Points and triangles are
 * divided into blocks (Parallel.h), each with three sums, one per coordinate or corner; the sums of
 * all blocks are the words of the final sum.
 *
 * TriangleChecksum() of a result is the sum of a hash of each triangle, which starts at its
 * smallest corner. So it does not depend on the order of points and triangles, files with the same
 * triangles have the same checksum, and the checksum of a whole is the sum of those of its parts.
 *
 * G. Fowler, L. C. Noll, K.-P. Vo: the hash of an input. SplitMix.h: the hash of a triangle.
 */
#ifndef BoneDecimate_Core_Mesh_Checksum_h
#define BoneDecimate_Core_Mesh_Checksum_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <string>

namespace bonedecimate
{
std::uint64_t Checksum(const Surface& surface, int threads = 1);

/// Checksum of the triangles alone, by their coordinates; 0 if there are none. Reversing a triangle
/// changes it.
std::uint64_t TriangleChecksum(const Surface& surface, int threads = 1);

/// "triangles:0123456789abcdef"
std::string TriangleChecksumText(std::uint64_t checksum);
}

#endif
