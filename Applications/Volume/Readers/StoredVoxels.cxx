// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StoredVoxels.h"

#include "DeflatedStream.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
class Bytes
{
public:
  explicit Bytes(const DataFile& data)
  {
    if (data.IsCompressed)
    {
      this->Packed.emplace(data.Path, data.Begin, data.Bytes);
      this->Skip(data.Skipped);
    }
    else
    {
      this->Plain.open(data.Path, std::ios::binary);
      this->Plain.seekg(static_cast<std::streamoff>(data.Begin + data.Skipped));
    }
  }

  /// False if there are fewer.
  bool Read(void* bytes, std::uint64_t count)
  {
    return this->Packed
      ? this->Packed->Read(bytes, count) == count
      : bool(this->Plain.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count)));
  }

private:
  void Skip(std::uint64_t count)
  {
    std::vector<char> ignored(std::size_t(1) << 18);
    while (count > 0 && this->Read(ignored.data(), std::min<std::uint64_t>(count, ignored.size())))
    {
      count -= std::min<std::uint64_t>(count, ignored.size());
    }
  }

  std::ifstream Plain;
  std::optional<DeflatedStream> Packed;
};

void ToOrderOfSystem(void* values, std::size_t count, std::size_t bytes, ByteOrder order)
{
  const bool isBig = order == ByteOrder::Big;
  switch (bytes)
  {
    case 2:
      return isBig ? vtkByteSwap::Swap2BERange(values, count)
                   : vtkByteSwap::Swap2LERange(values, count);
    case 4:
      return isBig ? vtkByteSwap::Swap4BERange(values, count)
                   : vtkByteSwap::Swap4LERange(values, count);
    case 8:
      return isBig ? vtkByteSwap::Swap8BERange(values, count)
                   : vtkByteSwap::Swap8LERange(values, count);
    default:
      return;
  }
}
}

LayeredVolume StoredLayers(const ItkHeader& header, const DataFile& data, ByteOrder order)
{
  LayeredVolume volume;
  volume.Header.Size = header.Size;
  volume.Header.ScalarType = header.ScalarType;
  volume.Header.Geometry = header.Geometry;
  const auto bytes = std::make_shared<Bytes>(data);
  const std::size_t count = volume.Header.BytesInALayer();
  const auto size = static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(header.ScalarType));
  volume.ReadLayer = [bytes, count, size, order](void* values)
  {
    if (!bytes->Read(values, count))
    {
      return std::string(DamagedVoxels);
    }
    ToOrderOfSystem(values, count / size, size, order);
    return std::string();
  };
  return volume;
}
}
