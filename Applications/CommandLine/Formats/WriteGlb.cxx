// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "ExitCode.h"
#include "FileParts.h"
#include "GlbFiles.h"
#include "MeshoptStreams.h"
#include "PointGrid.h"
#include "Report/Report.h"
#include "TextOutput.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

/// sRGB to linear, both from 0 to 1; glTF's factors and vertex colors are linear.
double Linear(unsigned char byte)
{
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// Six digits are more than a byte has.
double Shortened(double value)
{
  return std::round(value * 1e6) / 1e6;
}

std::vector<PositionStream> Quantized(const FilePart& part, const PointGrid& grid)
{
  std::vector<PositionStream> stream;
  stream.reserve(part.Points.size());
  for (const std::array<double, 3>& point : part.Points)
  {
    PositionStream whole = {};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      whole[axis] =
        static_cast<std::uint16_t>(std::lround((point[axis] - grid.Origin[axis]) / grid.Step));
    }
    stream.push_back(whole);
  }
  return stream;
}

std::vector<ColorStream> LinearColors(const FilePart& part, vtkUnsignedCharArray* colors)
{
  std::vector<ColorStream> stream;
  for (const vtkIdType point : part.OriginalPoints)
  {
    ColorStream color = { 0, 0, 0, 255 };
    for (int channel = 0; channel < 3; ++channel)
    {
      const unsigned char byte = colors->GetTypedComponent(point, channel);
      color[static_cast<std::size_t>(channel)] =
        static_cast<std::uint8_t>(std::lround(255.0 * Linear(byte)));
    }
    stream.push_back(color);
  }
  return stream;
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
  explicit GlbComposer(const PointGrid& grid)
    : Grid(grid)
  {
    this->Document["asset"] = { { "version", "2.0" },
      { "generator", std::string("bonedecimate ") + Version() } };
    const Json extensions = { QuantizationExtension, MeshoptExtension };
    this->Document["extensionsUsed"] = extensions;
    this->Document["extensionsRequired"] = extensions;
    this->Document["scene"] = 0;
    Json scene;
    scene["nodes"] = Json::array({ 0 });
    this->Document["scenes"] = Json::array({ scene });
    // Columns: x, y and z of the surface in glTF, where y is up and lengths are meters.
    Json frame;
    frame["matrix"] = { 0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1 };
    frame["children"] = Json::array();
    frame["extras"]["unit"] = "mm";
    this->Document["nodes"] = Json::array({ frame });
  }

  void Add(const FilePart& part, vtkUnsignedCharArray* colors)
  {
    const CompressedPart compressed = Compress(part.Corners, Quantized(part, this->Grid),
      colors != nullptr ? LinearColors(part, colors) : std::vector<ColorStream>());
    const int mesh = this->Count("meshes");
    Json primitive;
    primitive["attributes"]["POSITION"] = this->AddPositions(compressed);
    primitive["indices"] = this->AddIndices(compressed);
    primitive["material"] = this->AddMaterial(part);
    if (colors != nullptr)
    {
      primitive["attributes"]["COLOR_0"] = this->AddColors(compressed);
    }
    Json triangles;
    triangles["primitives"] = Json::array({ primitive });
    this->Document["meshes"].push_back(triangles);
    const double s = this->Grid.Step;
    const int number = this->Count("nodes");
    Json node = { { "mesh", mesh }, { "translation", this->Grid.Origin },
      { "scale", { s, s, s } } };
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
    Json compressed;
    compressed["byteLength"] = this->Binary.size();
    Json fallback;
    fallback["byteLength"] = this->Decoded;
    fallback["extensions"][MeshoptExtension]["fallback"] = true;
    this->Document["buffers"] = Json::array({ compressed, fallback });
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
      factor.push_back(Shortened(Linear(byte)));
    }
    factor.push_back(1.0);
    Json material;
    material["pbrMetallicRoughness"] = { { "baseColorFactor", factor }, { "metallicFactor", 0 },
      { "roughnessFactor", roughness } };
    this->Document["materials"].push_back(material);
    return number;
  }

  /// @param stream Its bytes decoded: count x stride.
  int AddView(const std::string& bytes, std::size_t count, std::size_t stride, const char* mode)
  {
    constexpr int arrayBuffer = 34962;
    constexpr int elementArrayBuffer = 34963;
    const int number = this->Count("bufferViews");
    const bool isIndex = std::string(mode) == "TRIANGLES";
    Json view = { { "buffer", 1 }, { "byteOffset", this->Decoded },
      { "byteLength", count * stride } };
    if (!isIndex)
    {
      view["byteStride"] = stride;
    }
    view["target"] = isIndex ? elementArrayBuffer : arrayBuffer;
    view["extensions"][MeshoptExtension] = { { "buffer", 0 }, { "byteOffset", this->Binary.size() },
      { "byteLength", bytes.size() }, { "byteStride", stride }, { "count", count },
      { "mode", mode } };
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

  int AddPositions(const CompressedPart& part)
  {
    const int view =
      this->AddView(part.Positions, part.NumberOfPoints, sizeof(PositionStream), "ATTRIBUTES");
    return this->AddAccessor({ { "bufferView", view }, { "componentType", UnsignedShort },
      { "count", part.NumberOfPoints }, { "type", "VEC3" }, { "min", part.Least },
      { "max", part.Most } });
  }

  int AddColors(const CompressedPart& part)
  {
    constexpr int unsignedByte = 5121;
    const int view =
      this->AddView(part.Colors, part.NumberOfPoints, sizeof(ColorStream), "ATTRIBUTES");
    return this->AddAccessor({ { "bufferView", view }, { "componentType", unsignedByte },
      { "normalized", true }, { "count", part.NumberOfPoints }, { "type", "VEC4" } });
  }

  int AddIndices(const CompressedPart& part)
  {
    constexpr std::size_t mostShort = 65535; // the last number restarts primitives
    const bool isShort = part.NumberOfPoints <= mostShort;
    const int view =
      this->AddView(part.Indices, part.NumberOfCorners, isShort ? 2 : 4, "TRIANGLES");
    return this->AddAccessor(
      { { "bufferView", view }, { "componentType", isShort ? UnsignedShort : UnsignedInt },
        { "count", part.NumberOfCorners }, { "type", "SCALAR" } });
  }

  PointGrid Grid;
  Json Document;
  std::string Binary;
  std::size_t Decoded = 0; // bytes
};
}

void WriteGlbFile(vtkPolyData* surface, const std::string& path)
{
  const std::optional<PointGrid> grid = FindGrid(surface);
  if (!grid)
  {
    throw Failure(
      ExitCode::CouldNotWrite, "the points are not on one grid of 65536 steps, which glb needs");
  }
  auto* colors =
    vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetAbstractArray(VertexColorArray));
  GlbComposer composer(*grid);
  for (const FilePart& part : PartsOf(surface))
  {
    composer.Add(part, colors);
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

#endif
