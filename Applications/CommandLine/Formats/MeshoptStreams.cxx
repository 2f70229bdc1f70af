// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshoptStreams.h"

#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include <meshoptimizer.h>

#include <algorithm>

namespace bonedecimate
{
namespace
{
unsigned char* BytesOf(std::string& text)
{
  return reinterpret_cast<unsigned char*>(text.data());
}
const unsigned char* BytesOf(const std::string& text)
{
  return reinterpret_cast<const unsigned char*>(text.data());
}

/// @param remap From the old number of a point to the new one.
template <typename Element>
std::string EncodedPoints(
  const std::vector<Element>& elements, const std::vector<unsigned int>& remap)
{
  std::vector<Element> ordered(elements.size());
  meshopt_remapVertexBuffer(
    ordered.data(), elements.data(), elements.size(), sizeof(Element), remap.data());
  std::string bytes(meshopt_encodeVertexBufferBound(elements.size(), sizeof(Element)), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(
    BytesOf(bytes), bytes.size(), ordered.data(), ordered.size(), sizeof(Element)));
  return bytes;
}

/// Numbers the points by their first use and encodes all streams.
CompressedPart Encoded(std::vector<unsigned int> corners,
  const std::vector<PositionStream>& positions, const std::vector<ColorStream>& colors)
{
  std::vector<unsigned int> remap(positions.size());
  meshopt_optimizeVertexFetchRemap(remap.data(), corners.data(), corners.size(), positions.size());
  meshopt_remapIndexBuffer(corners.data(), corners.data(), corners.size(), remap.data());
  CompressedPart part;
  part.NumberOfPoints = positions.size();
  part.NumberOfCorners = corners.size();
  part.Indices.resize(meshopt_encodeIndexBufferBound(corners.size(), positions.size()));
  part.Indices.resize(meshopt_encodeIndexBuffer(
    BytesOf(part.Indices), part.Indices.size(), corners.data(), corners.size()));
  part.Positions = EncodedPoints(positions, remap);
  part.Colors = colors.empty() ? std::string() : EncodedPoints(colors, remap);
  return part;
}

std::size_t BytesIn(const CompressedPart& part)
{
  return part.Indices.size() + part.Positions.size() + part.Colors.size();
}
}

CompressedPart Compress(const std::vector<std::uint32_t>& corners,
  const std::vector<PositionStream>& positions, const std::vector<ColorStream>& colors)
{
  meshopt_encodeIndexVersion(1); // that of the extension
  meshopt_encodeVertexVersion(0);
  CompressedPart best = Encoded(corners, positions, colors);
  using Order = void (*)(unsigned int*, const unsigned int*, std::size_t, std::size_t);
  for (const Order optimize :
    { Order(meshopt_optimizeVertexCache), Order(meshopt_optimizeVertexCacheStrip) })
  {
    std::vector<unsigned int> ordered(corners.size());
    optimize(ordered.data(), corners.data(), corners.size(), positions.size());
    CompressedPart other = Encoded(std::move(ordered), positions, colors);
    if (BytesIn(other) < BytesIn(best))
    {
      best = std::move(other);
    }
  }
  best.Least.fill(UINT16_MAX);
  for (const PositionStream& position : positions)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      best.Least[axis] = std::min(best.Least[axis], position[axis]);
      best.Most[axis] = std::max(best.Most[axis], position[axis]);
    }
  }
  return best;
}

//------------------------------------------------------------------------------
bool DecodeCorners(const std::string& bytes, std::size_t count, std::vector<std::uint32_t>& corners)
{
  corners.resize(count);
  return meshopt_decodeIndexBuffer(
           corners.data(), count, sizeof(std::uint32_t), BytesOf(bytes), bytes.size()) == 0;
}

bool DecodePositions(
  const std::string& bytes, std::size_t count, std::vector<PositionStream>& positions)
{
  positions.resize(count);
  return meshopt_decodeVertexBuffer(
           positions.data(), count, sizeof(PositionStream), BytesOf(bytes), bytes.size()) == 0;
}
}

#endif
