// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "GltfDocument.h"

#include "FileChecks.h"
#include "FilePath.h"
#include "GlbFiles.h"
#include "GltfBytes.h"
#include "GltfJson.h"
#include "MeshoptStreams.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace bonedecimate
{
namespace
{
constexpr std::size_t HeaderBytes = 12;
constexpr std::size_t ChunkBytes = 8;

std::string BytesOfFile(const std::string& path)
{
  std::ifstream stream(FilePath(path), std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

std::size_t WordAt(std::string_view bytes, std::size_t offset)
{
  std::size_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    word |= std::size_t(static_cast<unsigned char>(bytes[offset + i])) << 8 * i;
  }
  return word;
}

std::size_t SizeIn(const nlohmann::json& object, const char* name, std::size_t otherwise)
{
  return object.contains(name) ? object.at(name).get<std::size_t>() : otherwise;
}
}

GltfDocument::GltfDocument(const std::string& path)
  : Path(path)
  , File(BytesOfFile(path))
{
  constexpr double mostRepeated = 20.0; // times the file
  constexpr double alwaysAllowed = 1e9; // bytes
  this->BytesLeft = std::max(alwaysAllowed, mostRepeated * static_cast<double>(this->File.size()));
  this->Split();
}

void GltfDocument::Fail(const std::string& reason) const
{
  Reject(this->Path, reason);
}

void GltfDocument::Split()
{
  const std::string_view file = this->File;
  if (file.size() < HeaderBytes || WordAt(file, 0) != GlbMagic ||
    WordAt(file, 8) > this->File.size())
  {
    this->Fail("it is cut off, or not a GLB file");
  }
  if (WordAt(file, 4) != 2)
  {
    this->Fail("it is a GLB file of version " + std::to_string(WordAt(file, 4)) +
      "; version 2 is read, to which most programs convert");
  }
  const std::string_view content = file.substr(0, std::max(WordAt(file, 8), HeaderBytes));
  this->BytesBehind = file.size() - content.size();
  std::string_view json;
  for (std::size_t at = HeaderBytes; at < content.size();)
  {
    if (content.size() - at < ChunkBytes || WordAt(content, at) > content.size() - at - ChunkBytes)
    {
      this->Fail("it is cut off, or not a GLB file");
    }
    const std::string_view chunk = content.substr(at + ChunkBytes, WordAt(content, at));
    const std::size_t kind = WordAt(content, at + 4);
    json = kind == JsonChunk && json.empty() ? chunk : json;
    this->Binary = kind == BinaryChunk && this->Binary.empty() ? chunk : this->Binary;
    at += ChunkBytes + chunk.size();
  }
  constexpr std::size_t mostForJson = 500000000; // bytes, half of what is allowed
  if (!FitsJson(json, mostForJson))
  {
    this->Fail("its JSON takes more than 500 MB; points and triangles belong into the binary part");
  }
  this->Document = Json::parse(json, nullptr, false);
  if (!this->Document.is_object())
  {
    this->Fail("its JSON is damaged");
  }
}

void GltfDocument::Claim(std::size_t bytes)
{
  this->BytesLeft -= static_cast<double>(bytes);
  if (this->BytesLeft < 0.0)
  {
    this->Fail("what it describes takes more than a gigabyte and twenty times its size");
  }
}

const GltfDocument::Json& GltfDocument::EntryOf(const char* list, const Json& index) const
{
  const auto found = this->Document.find(list);
  const std::size_t number = index.is_number_unsigned() ? index.get<std::size_t>() : SIZE_MAX;
  if (found == this->Document.end() || !found->is_array() || number >= found->size())
  {
    this->Fail(std::string("its ") + list + " have no number " + index.dump().substr(0, 20));
  }
  return (*found)[number];
}

std::string_view GltfDocument::BytesOfBuffer(const Json& index)
{
  const Json& buffer = this->EntryOf("buffers", index);
  const auto number = index.get<std::size_t>();
  if (!buffer.contains("uri"))
  {
    if (number != 0)
    {
      this->Fail("the bytes of a buffer are not in the file");
    }
    return this->Binary;
  }
  const std::string& uri = buffer.at("uri").get_ref<const std::string&>();
  const std::size_t comma = uri.find(";base64,");
  if (uri.rfind("data:", 0) != 0 || comma == std::string::npos)
  {
    this->Fail("its points are in the file '" + PrintableText(uri.substr(0, 100)) +
      "'; GLB files with everything inside are read");
  }
  if (this->DataUris.count(number) == 0)
  {
    this->DataUris[number] = BytesOfBase64(std::string_view(uri).substr(comma + 8));
  }
  return this->DataUris[number];
}

const std::string& GltfDocument::DecodedView(const Json& index, const Json& compressed)
{
  const auto number = index.get<std::size_t>();
  const auto known = this->Decoded.find(number);
  if (known != this->Decoded.end())
  {
    return known->second;
  }
  const std::string_view buffer = this->BytesOfBuffer(compressed.at("buffer"));
  const std::size_t offset = SizeIn(compressed, "byteOffset", 0);
  const auto length = compressed.at("byteLength").get<std::size_t>();
  MeshoptView view;
  view.Count = compressed.at("count").get<std::size_t>();
  view.Stride = compressed.at("byteStride").get<std::size_t>();
  view.Mode = compressed.at("mode").get<std::string>();
  view.Filter = compressed.value("filter", std::string("NONE"));
  if (offset > buffer.size() || length > buffer.size() - offset)
  {
    this->Fail("a buffer reaches beyond the file");
  }
  constexpr std::size_t mostStride = 256;
  const bool isSound =
    view.Stride > 0 && view.Stride <= mostStride && view.Count <= SIZE_MAX / mostStride / 2;
  std::string bytes;
  std::string problem = isSound ? std::string() : "a compressed buffer is damaged";
  if (problem.empty())
  {
    this->Claim(view.Count * view.Stride);
    problem = DecodeView(buffer.substr(offset, length), view, bytes);
  }
  if (!problem.empty())
  {
    this->Fail(problem);
  }
  return this->Decoded.emplace(number, std::move(bytes)).first->second;
}

const GltfDocument::Json* GltfDocument::CompressionOf(const Json& view) const
{
  const Json none = Json::array();
  const Json& root = this->Document;
  const Json& required = root.contains("extensionsRequired") ? root.at("extensionsRequired") : none;
  for (const char* name : { MeshoptExtension, KhronosMeshoptExtension })
  {
    const bool isUsed = view.contains("extensions") && view.at("extensions").contains(name);
    const bool isRequired = std::find(required.begin(), required.end(), name) != required.end();
    if (!isUsed)
    {
      continue;
    }
    const Json& buffer = this->EntryOf("buffers", view.at("buffer"));
    const bool isPlaceholder = buffer.contains("extensions") &&
      buffer.at("extensions").value(name, Json::object()).value("fallback", false);
    if (isRequired || isPlaceholder)
    {
      return &view.at("extensions").at(name);
    }
  }
  return nullptr;
}

std::string_view GltfDocument::BytesOfView(const Json& index, std::size_t& stride)
{
  const Json& view = this->EntryOf("bufferViews", index);
  stride = SizeIn(view, "byteStride", 0);
  if (const Json* const compressed = this->CompressionOf(view))
  {
    stride = compressed->at("byteStride").get<std::size_t>();
    return this->DecodedView(index, *compressed);
  }
  const std::string_view buffer = this->BytesOfBuffer(view.at("buffer"));
  const std::size_t offset = SizeIn(view, "byteOffset", 0);
  const auto length = view.at("byteLength").get<std::size_t>();
  if (offset > buffer.size() || length > buffer.size() - offset)
  {
    this->Fail("a buffer reaches beyond the file");
  }
  return buffer.substr(offset, length);
}

GltfDocument::Layout GltfDocument::LayoutOf(const Json& accessor) const
{
  const auto& type = accessor.at("type").get_ref<const std::string&>();
  const std::pair<const char*, std::size_t> types[] = { { "SCALAR", 1 }, { "VEC2", 2 },
    { "VEC3", 3 }, { "VEC4", 4 } };
  Layout layout;
  for (const auto& [name, components] : types)
  {
    layout.Components = type == name ? components : layout.Components;
  }
  layout.ComponentType = accessor.at("componentType").get<int>();
  const ComponentRow* const row = FindComponent(layout.ComponentType);
  if (row == nullptr || layout.Components == 0)
  {
    this->Fail("an accessor has the type '" + PrintableText(type.substr(0, 20)) + "' of " +
      std::to_string(layout.ComponentType) + ", which is not known");
  }
  layout.ComponentBytes = row->Bytes;
  layout.IsNormalized = accessor.value("normalized", false);
  return layout;
}

void GltfDocument::ReadElements(
  const Json& source, const Layout& layout, std::size_t count, double* values)
{
  std::size_t stride = 0;
  const std::string_view bytes = this->BytesOfView(source.at("bufferView"), stride);
  const std::size_t size = layout.Components * layout.ComponentBytes;
  stride = stride == 0 ? size : stride;
  const std::size_t offset = SizeIn(source, "byteOffset", 0);
  if (stride < size || offset > bytes.size() ||
    (count > 0 &&
      (bytes.size() - offset < size || (bytes.size() - offset - size) / stride < count - 1)))
  {
    this->Fail("an accessor reaches beyond its buffer");
  }
  const ComponentRow& row = *FindComponent(layout.ComponentType);
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* const element = bytes.data() + offset + i * stride;
    for (std::size_t k = 0; k < layout.Components; ++k)
    {
      const double number = row.Read(element + k * layout.ComponentBytes);
      *values++ = layout.IsNormalized ? std::max(number / row.Most, -1.0) : number;
    }
  }
}

void GltfDocument::ApplySparse(const Json& sparse, const Layout& layout, GltfNumbers& numbers)
{
  const auto count = sparse.at("count").get<std::size_t>();
  if (count > numbers.Count)
  {
    this->Fail("a sparse accessor changes more elements than it has");
  }
  Layout ofIndices;
  ofIndices.Components = 1;
  ofIndices.ComponentType = sparse.at("indices").at("componentType").get<int>();
  const ComponentRow* const row = FindComponent(ofIndices.ComponentType);
  ofIndices.ComponentBytes = row == nullptr ? 0 : row->Bytes;
  if (row == nullptr)
  {
    this->Fail("a sparse accessor is damaged");
  }
  this->Claim(count * (1 + layout.Components) * sizeof(double));
  std::vector<double> indices(count);
  std::vector<double> values(count * layout.Components);
  this->ReadElements(sparse.at("indices"), ofIndices, count, indices.data());
  this->ReadElements(sparse.at("values"), layout, count, values.data());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!(indices[i] >= 0.0 && indices[i] < static_cast<double>(numbers.Count)))
    {
      this->Fail("a sparse accessor changes an element that is not there");
    }
    std::copy_n(values.data() + i * layout.Components, layout.Components,
      numbers.Values.data() + static_cast<std::size_t>(indices[i]) * layout.Components);
  }
}

const GltfNumbers& GltfDocument::NumbersOf(const Json& accessorIndex)
{
  const Json& accessor = this->EntryOf("accessors", accessorIndex);
  std::unique_ptr<GltfNumbers>& numbers = this->Numbers[accessorIndex.get<std::size_t>()];
  if (numbers != nullptr)
  {
    return *numbers;
  }
  const Layout layout = this->LayoutOf(accessor);
  auto made = std::make_unique<GltfNumbers>();
  made->Count = accessor.at("count").get<std::size_t>();
  made->Components = layout.Components;
  constexpr std::size_t mostCount = SIZE_MAX / 64;
  this->Claim(std::min(made->Count, mostCount) * layout.Components * sizeof(double));
  made->Values.resize(made->Count * layout.Components);
  if (accessor.contains("bufferView"))
  {
    this->ReadElements(accessor, layout, made->Count, made->Values.data());
  }
  if (accessor.contains("sparse"))
  {
    this->ApplySparse(accessor.at("sparse"), layout, *made);
  }
  numbers = std::move(made);
  return *numbers;
}

std::vector<std::uint32_t> GltfDocument::IndicesOf(const Json& accessorIndex)
{
  const GltfNumbers& numbers = this->NumbersOf(accessorIndex);
  std::vector<std::uint32_t> indices;
  indices.reserve(numbers.Values.size());
  for (const double number : numbers.Values)
  {
    if (!(number >= 0.0 && number <= static_cast<double>(UINT32_MAX) &&
          number == std::floor(number)))
    {
      this->Fail("the indices of its triangles are no whole numbers");
    }
    indices.push_back(static_cast<std::uint32_t>(number));
  }
  return indices;
}
}

#endif
