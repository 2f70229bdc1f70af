// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabReader.h"

#include <algorithm>

namespace bonedecimate::volume
{
namespace
{
constexpr std::int64_t BytesOfAVisit = std::int64_t(1) << 26;
}

Volume SlabReader::ReadTo(std::int64_t lastLayer)
{
  const VolumeHeader& header = this->GetHeader();
  const std::int64_t newLayers = lastLayer + 1 - this->NextLayer;
  const std::int64_t sharedLayers = this->SharedLayer.empty() ? 0 : 1;
  Volume slab;
  slab.Geometry = header.Geometry;
  slab.Layers = header.Layers;
  slab.Image = AllocateImage(
    { { header.Size[0], header.Size[1], sharedLayers + newLayers } }, header.ScalarType);
  slab.Image->SetExtent(0, static_cast<int>(header.Size[0]) - 1, 0,
    static_cast<int>(header.Size[1]) - 1, static_cast<int>(this->NextLayer - sharedLayers),
    static_cast<int>(lastLayer));
  char* values = static_cast<char*>(slab.Image->GetScalarPointer());
  values = std::copy(this->SharedLayer.begin(), this->SharedLayer.end(), values);
  const std::string problem = this->Reader->ReadLayers(newLayers, values);
  if (!problem.empty())
  {
    return RejectedVolume(problem);
  }
  const std::size_t bytes = header.BytesInALayer();
  const char* const end = values + static_cast<std::size_t>(newLayers) * bytes;
  this->SharedLayer.assign(end - bytes, end);
  this->NextLayer = lastLayer + 1;
  return slab;
}

//------------------------------------------------------------------------------
std::string VisitSlabs(SlabReader& reader, const std::function<std::string(const Volume&)>& visit)
{
  const VolumeHeader& header = reader.GetHeader();
  const std::int64_t layers =
    std::max<std::int64_t>(1, BytesOfAVisit / static_cast<std::int64_t>(header.BytesInALayer()));
  std::string problem;
  for (std::int64_t last = layers; !reader.IsAtEnd() && problem.empty(); last += layers)
  {
    const Volume slab = reader.ReadTo(std::min(last, header.Size[2] - 1));
    problem = slab.Problem.empty() ? visit(slab) : slab.Problem;
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string ProblemOfSecondReading(
  const VolumeHeader& header, const std::array<std::int64_t, 3>& size, std::size_t bytesInALayer)
{
  const bool isSame = header.Size == size && header.BytesInALayer() == bytesInALayer;
  return header.Problem.empty() && !isSame ? "it changes while it is read" : header.Problem;
}
}
