// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checksum.h
 * @brief A checksum of the points and triangles of an input.
 *
 * FNV-1a over 64-bit words instead of bytes. Points and triangles are divided into blocks (Parallel.h), each with three
 * sums, one for each coordinate or corner; the sums of all blocks are the words of the final sum.
 *
 * G. Fowler, L. C. Noll, K.-P. Vo: the hash.
 */
#ifndef BoneDecimate_Core_Mesh_Checksum_h
#define BoneDecimate_Core_Mesh_Checksum_h

#include "Surface.h"

namespace bonedecimate
{
std::uint64_t Checksum(const Surface& surface, int threads = 1);
}

#endif
