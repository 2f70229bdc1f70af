// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataFile.h"

#include "DeflatedStream.h"
#include "FilePath.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace bonedecimate::volume
{
std::uint64_t SizeOfFile(const std::string& path)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(FilePath(path), error);
  return error ? 0 : size;
}

DataFile DataFileBeside(
  const std::string& header, const std::string& name, std::uint64_t begin, bool isCompressed)
{
  DataFile data;
  data.Path = (FilePath(header).parent_path() / FilePath(name)).string();
  const std::uint64_t size = SizeOfFile(data.Path);
  data.Begin = std::min(size, begin);
  data.Bytes = size - data.Begin;
  data.IsCompressed = isCompressed;
  return data;
}

std::string ComponentsProblem(const ItkHeader& header)
{
  return header.Components == 1 ? std::string()
                                : "it has " + std::to_string(header.Components) +
      " values a voxel, a CT or a label map has one";
}

std::string DataProblem(const ItkHeader& header, const DataFile& data)
{
  const int bytesPerVoxel = vtkDataArray::GetDataTypeSize(header.ScalarType) * header.Components;
  const std::string problem =
    SizeProblem(header.Size, bytesPerVoxel, data.Bytes, data.IsCompressed);
  if (!problem.empty() || !data.IsCompressed)
  {
    return problem;
  }
  std::uint64_t bytes = static_cast<std::uint64_t>(bytesPerVoxel);
  for (const std::int64_t size : header.Size)
  {
    bytes *= static_cast<std::uint64_t>(size);
  }
  return InflatedSize(data.Path, data.Begin, data.Bytes) == bytes + data.Skipped ? problem
                                                                                 : DamagedVoxels;
}

std::string FirstOf(std::initializer_list<std::string> problems)
{
  const auto first = std::find_if(
    problems.begin(), problems.end(), [](const std::string& text) { return !text.empty(); });
  return first == problems.end() ? std::string() : *first;
}
}
