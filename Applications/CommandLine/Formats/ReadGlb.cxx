// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Only files of WriteGlb.cxx, so that what is certified is what a reader decodes. Of other glTF files neither the unit nor
/// the frame of the patient is known.
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "FileChecks.h"
#include "FileParts.h"
#include "GlbFiles.h"
#include "MeshoptStreams.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

std::string BytesOfFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

/// From linear to sRGB: the inverse of the writer's.
unsigned char ByteOf(double linear)
{
  const double value =
    linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

class GlbReader
{
public:
  explicit GlbReader(const std::string& path)
    : Path(path)
    , File(BytesOfFile(path))
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    this->Split();
    try
    {
      this->RequireOwn();
      std::vector<FilePart> parts;
      for (const Json& child : this->Document.at("nodes").at(0).at("children"))
      {
        parts.push_back(this->ReadPart(this->Document.at("nodes").at(child.get<std::size_t>())));
      }
      return JoinParts(parts);
    }
    catch (const Json::exception& problem)
    {
      Reject(this->Path, std::string("its JSON is damaged: ") + problem.what());
    }
  }

private:
  static constexpr std::size_t HeaderBytes = 12;
  static constexpr std::size_t ChunkBytes = 8;

  std::size_t WordAt(std::size_t offset) const
  {
    std::size_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      word |= std::size_t(static_cast<unsigned char>(this->File[offset + i])) << 8 * i;
    }
    return word;
  }

  /// The chunk that begins there; its end.
  std::size_t ReadChunk(std::size_t begin, std::uint32_t kind, std::string& content) const
  {
    if (this->File.size() < begin + ChunkBytes || this->WordAt(begin + 4) != kind ||
      this->WordAt(begin) > this->File.size() - begin - ChunkBytes)
    {
      Reject(this->Path, "it is cut off, or not a GLB file");
    }
    content = this->File.substr(begin + ChunkBytes, this->WordAt(begin));
    return begin + ChunkBytes + content.size();
  }

  void Split()
  {
    if (this->File.size() < HeaderBytes || this->WordAt(0) != GlbMagic || this->WordAt(4) != 2 ||
      this->WordAt(8) != this->File.size())
    {
      Reject(this->Path, "it is cut off, or not a GLB file of version 2");
    }
    std::string json;
    const std::size_t next = this->ReadChunk(HeaderBytes, JsonChunk, json);
    this->ReadChunk(next, BinaryChunk, this->Binary);
    this->Document = Json::parse(json, nullptr, false);
  }

  void RequireOwn() const
  {
    const bool isObject = this->Document.is_object() && this->Document.contains("asset");
    const std::string generator =
      isObject ? this->Document["asset"].value("generator", std::string()) : std::string();
    if (generator.rfind("bonedecimate ", 0) != 0 ||
      this->Document.at("nodes").at(0).at("extras").at("unit") != "mm")
    {
      Reject(this->Path,
        "it was not written by this program; of other glTF files unit and frame are not known");
    }
  }

  /// The compressed bytes of an accessor, and how many elements they hold.
  std::string StreamOf(const Json& accessor, const char* mode, std::size_t& count) const
  {
    const Json& view = this->Document.at("bufferViews")
                         .at(accessor.at("bufferView").get<std::size_t>())
                         .at("extensions")
                         .at(MeshoptExtension);
    const auto offset = view.at("byteOffset").get<std::size_t>();
    const auto length = view.at("byteLength").get<std::size_t>();
    count = view.at("count").get<std::size_t>();
    // Both codecs take at least a byte for eight elements, so a damaged count cannot claim much memory.
    constexpr std::size_t mostPerByte = 8;
    if (view.at("mode") != mode || offset > this->Binary.size() ||
      length > this->Binary.size() - offset || count != accessor.at("count").get<std::size_t>() ||
      count > mostPerByte * length)
    {
      Reject(this->Path, "a buffer reaches beyond the file");
    }
    return this->Binary.substr(offset, length);
  }

  FilePart ReadPart(const Json& node) const
  {
    const Json& primitive =
      this->Document.at("meshes").at(node.at("mesh").get<std::size_t>()).at("primitives").at(0);
    const Json& accessors = this->Document.at("accessors");
    const Json& positions =
      accessors.at(primitive.at("attributes").at("POSITION").get<std::size_t>());
    FilePart part;
    std::size_t count = 0;
    std::vector<PositionStream> whole;
    const std::string points = this->StreamOf(positions, "ATTRIBUTES", count);
    if (!DecodePositions(points, count, whole))
    {
      Reject(this->Path, "its positions are damaged");
    }
    const auto origin = node.at("translation").get<std::array<double, 3>>();
    const auto scale = node.at("scale").get<std::array<double, 3>>();
    for (const PositionStream& p : whole)
    {
      part.Points.push_back(
        { origin[0] + scale[0] * p[0], origin[1] + scale[1] * p[1], origin[2] + scale[2] * p[2] });
    }
    const Json& indices = accessors.at(primitive.at("indices").get<std::size_t>());
    const std::string stream = this->StreamOf(indices, "TRIANGLES", count);
    const bool isWhole = count % 3 == 0 && DecodeCorners(stream, count, part.Corners) &&
      std::all_of(part.Corners.begin(), part.Corners.end(),
        [&part](std::uint32_t corner) { return corner < part.Points.size(); });
    if (!isWhole)
    {
      Reject(this->Path, "its triangles are damaged");
    }
    this->ReadLabel(node, primitive, part);
    return part;
  }

  void ReadLabel(const Json& node, const Json& primitive, FilePart& part) const
  {
    if (!node.contains("extras"))
    {
      return;
    }
    NamedLabel label;
    label.Value = node.at("extras").at("label").get<std::int64_t>();
    label.Name = node.value("name", std::string());
    const Json& color = this->Document.at("materials")
                          .at(primitive.at("material").get<std::size_t>())
                          .at("pbrMetallicRoughness")
                          .at("baseColorFactor");
    label.Color = LabelColor{ ByteOf(color.at(0).get<double>()), ByteOf(color.at(1).get<double>()),
      ByteOf(color.at(2).get<double>()) };
    part.Label = label;
  }

  const std::string& Path;
  std::string File;
  std::string Binary;
  Json Document;
};
}

vtkSmartPointer<vtkPolyData> ReadGlbFile(const std::string& path, std::vector<std::string>&)
{
  return GlbReader(path).Read();
}
}

#endif
