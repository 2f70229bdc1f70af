// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "ExitCode.h"
#include "FileParts.h"
#include "GlbFiles.h"
#include "GlbStreams.h"
#include "MeshoptStreams.h"
#include "PointGrid.h"
#include "Run/Report/Report.h"
#include "TextOutput.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

/// Six digits are more than a byte has.
double Shortened(double value)
{
  return std::round(value * 1e6) / 1e6;
}

void PutWord(std::size_t number, std::string& file)
{
  for (int shift = 0; shift < 32; shift += 8)
  {
    file += static_cast<char>(number >> shift & 0xFF);
  }
}

/// Composes the document and the binary chunk, part after part.
class GlbComposer
{
public:
  /// @param grid Grid of a compressed file; none: a plain file.
  explicit GlbComposer(const std::optional<PointGrid>& grid)
    : Grid(grid)
  {
    this->Document["asset"] = { { "version", "2.0" },
      { "generator", std::string("bonedecimate ") + Version() } };
    if (grid)
    {
      const Json extensions = { QuantizationExtension, MeshoptExtension };
      this->Document["extensionsUsed"] = extensions;
      this->Document["extensionsRequired"] = extensions;
    }
    this->Document["scene"] = 0;
    Json scene;
    scene["nodes"] = Json::array({ 0 });
    this->Document["scenes"] = Json::array({ scene });
    Json frame;
    frame["matrix"] = FrameMatrix;
    frame["children"] = Json::array();
    frame["extras"]["unit"] = "mm";
    this->Document["nodes"] = Json::array({ frame });
  }

  void Add(vtkPolyData* surface, const FilePart& part)
  {
    std::vector<GlbAttribute> attributes = AttributesOf(surface, part, this->Grid);
    std::string indices = IndexBytes(part);
    if (this->Grid)
    {
      CompressStreams(part, attributes, indices);
    }
    const int mesh = this->Count("meshes");
    Json primitive;
    for (const GlbAttribute& attribute : attributes)
    {
      primitive["attributes"][attribute.Name] = this->AddAttribute(attribute, part.Points.size());
    }
    primitive["indices"] = this->AddIndices(indices, part);
    primitive["material"] = this->AddMaterial(part);
    Json triangles;
    triangles["primitives"] = Json::array({ primitive });
    this->Document["meshes"].push_back(triangles);
    const int number = this->Count("nodes");
    Json node = { { "mesh", mesh } };
    if (this->Grid)
    {
      const double s = this->Grid->Step;
      node["translation"] = this->Grid->Origin;
      node["scale"] = { s, s, s };
    }
    if (part.Label)
    {
      node["name"] = NameOf(*part.Label);
      node["extras"]["label"] = part.Label->Value;
    }
    this->Document["nodes"].push_back(node);
    this->Document["nodes"][0]["children"].push_back(number);
  }

  std::string Compose()
  {
    Json binary;
    binary["byteLength"] = this->Binary.size();
    this->Document["buffers"] = Json::array({ binary });
    if (this->Grid)
    {
      Json fallback;
      fallback["byteLength"] = this->Decoded;
      fallback["extensions"][MeshoptExtension]["fallback"] = true;
      this->Document["buffers"].push_back(fallback);
    }
    std::string json = this->Document.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string file;
    PutWord(GlbMagic, file);
    PutWord(2, file); // the version
    PutWord(12 + 8 + json.size() + 8 + this->Binary.size(), file);
    PutWord(json.size(), file);
    PutWord(JsonChunk, file);
    file += json;
    PutWord(this->Binary.size(), file);
    PutWord(BinaryChunk, file);
    return file + this->Binary;
  }

private:
  static std::string NameOf(const NamedLabel& label)
  {
    return label.Name.empty() ? std::to_string(label.Value) : label.Name;
  }

  int Count(const char* list) const
  {
    return this->Document.contains(list) ? static_cast<int>(this->Document[list].size()) : 0;
  }

  int AddMaterial(const FilePart& part)
  {
    constexpr double roughness = 0.6;
    const int number = this->Count("materials");
    const LabelColor bone = { 226, 212, 186 };
    const LabelColor color = part.Label ? part.Label->Color.value_or(bone) : bone;
    Json factor = Json::array();
    for (const unsigned char byte : color)
    {
      factor.push_back(Shortened(LinearColor(byte)));
    }
    factor.push_back(1.0);
    Json material;
    material["pbrMetallicRoughness"] = { { "baseColorFactor", factor }, { "metallicFactor", 0 },
      { "roughnessFactor", roughness } };
    this->Document["materials"].push_back(material);
    return number;
  }

  /// The last number of two bytes restarts primitives.
  static bool HasShortIndices(const FilePart& part) { return part.Points.size() <= UINT16_MAX; }

  static std::string IndexBytes(const FilePart& part)
  {
    std::string bytes;
    for (const std::uint32_t corner : part.Corners)
    {
      for (int shift = 0; shift < (HasShortIndices(part) ? 16 : 32); shift += 8)
      {
        bytes += static_cast<char>(corner >> shift & 0xFF);
      }
    }
    return bytes;
  }

  static void CompressStreams(
    const FilePart& part, std::vector<GlbAttribute>& attributes, std::string& indices)
  {
    std::vector<PointStream> streams;
    streams.reserve(attributes.size());
    for (const GlbAttribute& attribute : attributes)
    {
      streams.push_back(attribute.Stream);
    }
    CompressedPart compressed = Compress(part.Corners, streams);
    for (std::size_t i = 0; i < attributes.size(); ++i)
    {
      attributes[i].Stream.Bytes = std::move(compressed.Streams[i]);
    }
    indices = std::move(compressed.Indices);
  }

  /// @param stride Bytes of an element that is not compressed.
  int AddView(const std::string& bytes, std::size_t count, std::size_t stride, bool isIndex)
  {
    constexpr int arrayBuffer = 34962;
    constexpr int elementArrayBuffer = 34963;
    const int number = this->Count("bufferViews");
    Json view = { { "buffer", this->Grid ? 1 : 0 },
      { "byteOffset", this->Grid ? this->Decoded : this->Binary.size() },
      { "byteLength", count * stride } };
    if (!isIndex)
    {
      view["byteStride"] = stride;
    }
    view["target"] = isIndex ? elementArrayBuffer : arrayBuffer;
    if (this->Grid)
    {
      view["extensions"][MeshoptExtension] = { { "buffer", 0 },
        { "byteOffset", this->Binary.size() }, { "byteLength", bytes.size() },
        { "byteStride", stride }, { "count", count },
        { "mode", isIndex ? "TRIANGLES" : "ATTRIBUTES" } };
    }
    this->Document["bufferViews"].push_back(view);
    this->Binary += bytes;
    this->Binary.resize((this->Binary.size() + 3) / 4 * 4);
    this->Decoded += (count * stride + 3) / 4 * 4;
    return number;
  }

  int AddAccessor(const Json& accessor)
  {
    this->Document["accessors"].push_back(accessor);
    return this->Count("accessors") - 1;
  }

  int AddAttribute(const GlbAttribute& attribute, std::size_t points)
  {
    Json accessor = { { "bufferView",
                        this->AddView(
                          attribute.Stream.Bytes, points, attribute.Stream.Stride, false) },
      { "componentType", attribute.ComponentType } };
    if (attribute.IsNormalized)
    {
      accessor["normalized"] = true;
    }
    accessor["count"] = points;
    accessor["type"] = "VEC" + std::to_string(attribute.Components);
    if (!attribute.Least.empty())
    {
      accessor["min"] = attribute.Least;
      accessor["max"] = attribute.Most;
    }
    return this->AddAccessor(accessor);
  }

  int AddIndices(const std::string& bytes, const FilePart& part)
  {
    constexpr int unsignedShort = 5123;
    constexpr int unsignedInt = 5125;
    const bool isShort = HasShortIndices(part);
    const int view = this->AddView(bytes, part.Corners.size(), isShort ? 2 : 4, true);
    return this->AddAccessor(
      { { "bufferView", view }, { "componentType", isShort ? unsignedShort : unsignedInt },
        { "count", part.Corners.size() }, { "type", "SCALAR" } });
  }

  std::optional<PointGrid> Grid;
  Json Document;
  std::string Binary;
  std::size_t Decoded = 0; // bytes
};

void WriteDocument(
  vtkPolyData* surface, const std::optional<PointGrid>& grid, const std::string& path)
{
  GlbComposer composer(grid);
  for (const FilePart& part : PartsOf(surface))
  {
    composer.Add(surface, part);
  }
  const std::string file = composer.Compose();
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(file.data(), static_cast<std::streamsize>(file.size()));
  stream.close();
  if (!stream)
  {
    throw Failure(ExitCode::CouldNotWrite, WriteProblem());
  }
}
}

void WriteGlbFile(vtkPolyData* surface, const std::string& path)
{
  WriteDocument(surface, {}, path);
}

void WriteCompressedGlbFile(vtkPolyData* surface, const std::string& path)
{
  const std::optional<PointGrid> grid = FindGrid(surface);
  if (!grid)
  {
    throw Failure(ExitCode::CouldNotWrite,
      "the points are not on one grid of 65536 steps, which compressed glb needs");
  }
  WriteDocument(surface, grid, path);
}
}

#endif
