// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NiftiExtensions.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <zlib.h>

namespace bonedecimate
{
namespace
{
constexpr std::size_t HeaderSize = 348;
constexpr std::size_t LargestTotal = std::size_t(1)
  << 26; // bytes, of what a damaged header can announce
class NiftiBeginning
{
public:
  explicit NiftiBeginning(const std::string& path)
    : File(gzopen(path.c_str(), "rb"))
  {
  }
  ~NiftiBeginning()
  {
    if (this->File)
    {
      gzclose(this->File);
    }
  }
  NiftiBeginning(const NiftiBeginning&) = delete;
  NiftiBeginning& operator=(const NiftiBeginning&) = delete;

  /// The next bytes; fewer where the file ends.
  std::string Read(std::size_t count)
  {
    std::string bytes(this->File ? count : 0, '\0');
    const int done =
      this->File ? gzread(this->File, bytes.data(), static_cast<unsigned int>(count)) : 0;
    bytes.resize(static_cast<std::size_t>(std::max(done, 0)));
    return bytes;
  }

private:
  gzFile File;
};

template <typename Number>
Number NumberAt(const std::string& bytes, std::size_t position, bool isSwapped)
{
  char copy[sizeof(Number)];
  std::copy_n(bytes.data() + position, sizeof(Number), copy);
  if (isSwapped)
  {
    std::reverse(copy, copy + sizeof(Number));
  }
  Number number;
  std::memcpy(&number, copy, sizeof(Number));
  return number;
}
}

std::vector<std::string> ReadNiftiExtensions(const std::string& path)
{
  NiftiBeginning file(path);
  const std::string header = file.Read(HeaderSize + 4);
  std::vector<std::string> extensions;
  if (header.size() < HeaderSize + 4 || header.compare(344, 3, "n+1") != 0 ||
    header[HeaderSize] == '\0')
  {
    return extensions;
  }
  const bool isSwapped =
    NumberAt<std::int32_t>(header, 0, false) != static_cast<std::int32_t>(HeaderSize);
  const float voxels = NumberAt<float>(header, 108, isSwapped);
  const double end = voxels > 0.0F && voxels < 1e9F ? static_cast<double>(voxels) : 0.0;
  double position = HeaderSize + 4;
  std::size_t total = 0;
  while (position + 8.0 <= end)
  {
    const std::string beginning = file.Read(8);
    const std::int32_t size =
      beginning.size() == 8 ? NumberAt<std::int32_t>(beginning, 0, isSwapped) : 0;
    position += size;
    total += static_cast<std::size_t>(std::max(size, 0));
    if (size < 8 || total > LargestTotal || position > end)
    {
      break; // the rest cannot be divided
    }
    std::string content = file.Read(static_cast<std::size_t>(size) - 8);
    content.erase(content.find_last_not_of('\0') + 1);
    extensions.push_back(std::move(content));
  }
  return extensions;
}
}
