// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DataFile.h
 * @brief The bytes of voxels in a file, checked before a reader of ITK gets them.
 */
#ifndef BoneDecimate_Applications_DataFile_h
#define BoneDecimate_Applications_DataFile_h

#include "ItkImage.h"

#include <cstdint>
#include <initializer_list>
#include <string>

namespace bonedecimate::volume
{
constexpr const char* DamagedVoxels = "its voxels are truncated or damaged";

/// Where the voxels lie.
struct DataFile
{
  std::string Path;
  std::uint64_t Begin = 0;
  std::uint64_t Bytes = 0;   ///< From there on.
  bool IsCompressed = false; ///< By zlib or gzip.
  std::uint64_t Skipped = 0; ///< Bytes before the voxels, after inflation.
};

/// 0 if it cannot be read.
std::uint64_t SizeOfFile(const std::string& path);

/// The data from the given byte to the end of a file that a header names relative to its folder.
DataFile DataFileBeside(
  const std::string& header, const std::string& name, std::uint64_t begin, bool isCompressed);

/// "it has 3 values a voxel", or an empty text.
std::string ComponentsProblem(const ItkHeader& header);

/// Whether the file can have and, if compressed, does have the voxels that the header announces.
std::string DataProblem(const ItkHeader& header, const DataFile& data);

/// The first text that is not empty.
std::string FirstOf(std::initializer_list<std::string> problems);
}

#endif
