// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfDocument.h
 * @brief The JSON and the binary chunk of a GLB file, and the numbers of its accessors.
 *
 *     accessor -> buffer view -> bytes of the chunk, of a data URI, or decoded by meshoptimizer ->
 *       numbers
 *
 * What a file may claim is limited to a gigabyte or twenty times its size.
 */
#ifndef BoneDecimate_Applications_GltfDocument_h
#define BoneDecimate_Applications_GltfDocument_h

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace bonedecimate
{
/// The numbers of an accessor, element after element; normalized ones are from -1 to 1.
struct GltfNumbers
{
  std::size_t Count = 0;
  std::size_t Components = 0;
  std::vector<double> Values;
};

class GltfDocument
{
public:
  using Json = nlohmann::json;

  /// @throws Failure(ExitCode::InputRejected)
  explicit GltfDocument(const std::string& path);

  const Json& Root() const { return this->Document; }

  /// Bytes of the file behind its contents.
  std::size_t ExtraBytes() const { return this->BytesBehind; }

  /// @name Of an accessor, which is decoded once. @throws Failure(ExitCode::InputRejected),
  /// Json::exception @{
  const GltfNumbers& NumbersOf(const Json& accessorIndex);
  std::vector<std::uint32_t> IndicesOf(const Json& accessorIndex);
  /// @}

  /// Counts memory that the result takes. @throws Failure(ExitCode::InputRejected) if it is too
  /// much.
  void Claim(std::size_t bytes);

  /// The entry of a list of the document, such as "meshes". @throws
  /// Failure(ExitCode::InputRejected)
  const Json& EntryOf(const char* list, const Json& index) const;

  [[noreturn]] void Fail(const std::string& reason) const;

private:
  /// Elements of one type at equal distances.
  struct Layout
  {
    std::size_t Components = 0;
    int ComponentType = 0;
    std::size_t ComponentBytes = 0;
    bool IsNormalized = false;
  };

  void Split();
  Layout LayoutOf(const Json& accessor) const;
  std::string_view BytesOfBuffer(const Json& index);
  std::string_view BytesOfView(const Json& index, std::size_t& stride);
  /// The entry of the view that says how it is compressed; null: its plain bytes are there.
  const Json* CompressionOf(const Json& view) const;
  const std::string& DecodedView(const Json& index, const Json& compressed);
  void ReadElements(const Json& source, const Layout& layout, std::size_t count, double* values);
  void ApplySparse(const Json& sparse, const Layout& layout, GltfNumbers& numbers);

  std::string Path;
  std::string File;
  std::string_view Binary;
  Json Document;
  std::size_t BytesBehind = 0;
  double BytesLeft = 0.0;
  std::map<std::size_t, std::string> Decoded; // compressed views, data URIs: by their number
  std::map<std::size_t, std::string> DataUris;
  std::map<std::size_t, std::unique_ptr<GltfNumbers>> Numbers;
};
}

#endif
