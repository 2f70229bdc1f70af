// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshoptStreams.h"

#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include <meshoptimizer.h>

#include <utility>

namespace bonedecimate
{
namespace
{
unsigned char* BytesOf(std::string& text)
{
  return reinterpret_cast<unsigned char*>(text.data());
}

/// @param remap Maps the old number of a point to the new one.
std::string EncodedPoints(const PointStream& stream, const std::vector<unsigned int>& remap)
{
  std::string ordered(stream.Bytes.size(), '\0');
  meshopt_remapVertexBuffer(
    ordered.data(), stream.Bytes.data(), remap.size(), stream.Stride, remap.data());
  std::string bytes(meshopt_encodeVertexBufferBound(remap.size(), stream.Stride), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(
    BytesOf(bytes), bytes.size(), ordered.data(), remap.size(), stream.Stride));
  return bytes;
}

/// Numbers the points by their first use and encodes all streams.
CompressedPart Encoded(std::vector<unsigned int> corners, const std::vector<PointStream>& streams)
{
  const std::size_t points = streams[0].Bytes.size() / streams[0].Stride;
  std::vector<unsigned int> remap(points);
  meshopt_optimizeVertexFetchRemap(remap.data(), corners.data(), corners.size(), points);
  meshopt_remapIndexBuffer(corners.data(), corners.data(), corners.size(), remap.data());
  CompressedPart part;
  part.Indices.resize(meshopt_encodeIndexBufferBound(corners.size(), points));
  part.Indices.resize(meshopt_encodeIndexBuffer(
    BytesOf(part.Indices), part.Indices.size(), corners.data(), corners.size()));
  for (const PointStream& stream : streams)
  {
    part.Streams.push_back(EncodedPoints(stream, remap));
  }
  return part;
}

std::size_t BytesIn(const CompressedPart& part)
{
  std::size_t bytes = part.Indices.size();
  for (const std::string& stream : part.Streams)
  {
    bytes += stream.size();
  }
  return bytes;
}

bool Filtered(const MeshoptView& view, std::string& decoded)
{
  using Decode = void (*)(void*, std::size_t, std::size_t);
  const std::pair<const char*, Decode> filters[] = { { "OCTAHEDRAL", meshopt_decodeFilterOct },
    { "QUATERNION", meshopt_decodeFilterQuat }, { "EXPONENTIAL", meshopt_decodeFilterExp } };
  for (const auto& [name, decode] : filters)
  {
    if (view.Filter == name)
    {
      const bool isOfFour = view.Stride == 4 || view.Stride == 8;
      const bool fits = view.Filter == "EXPONENTIAL" ? view.Stride % 4 == 0
        : view.Filter == "QUATERNION"                ? view.Stride == 8
                                                     : isOfFour;
      if (fits)
      {
        decode(decoded.data(), view.Count, view.Stride);
      }
      return fits;
    }
  }
  return view.Filter == "NONE";
}
}

CompressedPart Compress(
  const std::vector<std::uint32_t>& corners, const std::vector<PointStream>& streams)
{
  meshopt_encodeIndexVersion(1); // the version of the extension
  meshopt_encodeVertexVersion(0);
  const std::size_t points = streams[0].Bytes.size() / streams[0].Stride;
  CompressedPart best = Encoded(corners, streams);
  using Order = void (*)(unsigned int*, const unsigned int*, std::size_t, std::size_t);
  for (const Order optimize :
    { Order(meshopt_optimizeVertexCache), Order(meshopt_optimizeVertexCacheStrip) })
  {
    std::vector<unsigned int> ordered(corners.size());
    optimize(ordered.data(), corners.data(), corners.size(), points);
    CompressedPart other = Encoded(std::move(ordered), streams);
    if (BytesIn(other) < BytesIn(best))
    {
      best = std::move(other);
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::string DecodeView(std::string_view bytes, const MeshoptView& view, std::string& decoded)
{
  constexpr unsigned char attributesVersion1 = 0xA1;
  const std::string damaged = "a compressed buffer is damaged";
  const auto* const source = reinterpret_cast<const unsigned char*>(bytes.data());
  decoded.resize(view.Count * view.Stride);
  int result = -1;
  if (view.Mode == "ATTRIBUTES" && view.Stride % 4 == 0)
  {
    result =
      meshopt_decodeVertexBuffer(decoded.data(), view.Count, view.Stride, source, bytes.size());
    if (result != 0 && !bytes.empty() && source[0] == attributesVersion1)
    {
      return "its points are compressed by version 1 of meshoptimizer's codec, which this build "
             "does not read";
    }
    return result == 0 && Filtered(view, decoded) ? std::string() : damaged;
  }
  if (view.Stride != 2 && view.Stride != 4)
  {
    return damaged;
  }
  if (view.Mode == "TRIANGLES" && view.Count % 3 == 0)
  {
    result =
      meshopt_decodeIndexBuffer(decoded.data(), view.Count, view.Stride, source, bytes.size());
  }
  else if (view.Mode == "INDICES")
  {
    result =
      meshopt_decodeIndexSequence(decoded.data(), view.Count, view.Stride, source, bytes.size());
  }
  return result == 0 ? std::string() : damaged;
}
}

#endif
