// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentFrames.h"

#include <algorithm>
#include <utility>

namespace bonedecimate::volume
{
namespace
{
/// Calls visit(i) for each of the bits that is set, from the given one on.
template <typename Visit>
void VisitSetBits(
  const std::vector<unsigned char>& bytes, std::uint64_t first, std::size_t count, Visit visit)
{
  for (std::size_t i = 0; i < count;)
  {
    const std::uint64_t bit = first + i;
    const unsigned int rest = static_cast<unsigned int>(bytes[bit / 8]) >> bit % 8;
    if (rest == 0) // nor is any other up to the end of the byte
    {
      i += 8 - bit % 8;
      continue;
    }
    if ((rest & 1U) != 0)
    {
      visit(i);
    }
    ++i;
  }
}
}

std::uint64_t BytesOfPixels(std::uint64_t pixels, SegmentPixels type)
{
  switch (type)
  {
    case SegmentPixels::Bits:
      return (pixels + 7) / 8;
    case SegmentPixels::Bytes:
      return pixels;
    default:
      return 2 * pixels;
  }
}

SegmentFrames::SegmentFrames(SegmentPixels type, std::vector<unsigned char> bytes,
  const std::array<std::int64_t, 2>& size, const std::vector<Segment>& segments)
  : Type(type)
  , Bytes(std::move(bytes))
  , Pixels(static_cast<std::size_t>(size[0] * size[1]))
  , IsLabel(65536, false)
{
  this->IsLabel[0] = true;
  for (const Segment& segment : segments)
  {
    this->LabelOfSegment.push_back(static_cast<std::uint16_t>(segment.Label));
    this->IsLabel[this->LabelOfSegment.back()] = true;
  }
}

std::string SegmentFrames::Arrange(
  const std::vector<SegmentFrame>& frames, std::int64_t planes, const std::vector<bool>& isChosen)
{
  this->FramesOfPlane.assign(static_cast<std::size_t>(planes), {});
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    this->SegmentOfFrame.push_back(frames[i].Segment);
    if (this->Type != SegmentPixels::Bits || isChosen.empty() || isChosen[frames[i].Segment])
    {
      this->FramesOfPlane[static_cast<std::size_t>(frames[i].Plane)].push_back(i);
    }
  }
  for (std::vector<std::size_t>& plane : this->FramesOfPlane)
  {
    const auto isBefore = [this](std::size_t a, std::size_t b)
    { return this->SegmentOfFrame[a] < this->SegmentOfFrame[b]; };
    std::stable_sort(plane.begin(), plane.end(), isBefore);
    const auto isSame = [this](std::size_t a, std::size_t b)
    { return this->SegmentOfFrame[a] == this->SegmentOfFrame[b]; };
    const auto same = std::adjacent_find(plane.begin(), plane.end(), isSame);
    if (same != plane.end())
    {
      return "its frames " + std::to_string(*same + 1) + " and " + std::to_string(same[1] + 1) +
        " lie in the same plane";
    }
  }
  return std::string();
}

Overlap SegmentFrames::Combine(std::int64_t plane, std::uint16_t* labels) const
{
  const std::vector<std::size_t>& frames = this->FramesOfPlane[static_cast<std::size_t>(plane)];
  std::fill_n(labels, this->Pixels, std::uint16_t(0));
  if (this->Type == SegmentPixels::Bits)
  {
    return this->CombineBits(frames, labels);
  }
  Overlap overlap;
  overlap.Undescribed = frames.empty() ? 0 : this->CopyLabels(frames.front(), labels);
  return overlap;
}

Overlap SegmentFrames::CombineBits(
  const std::vector<std::size_t>& frames, std::uint16_t* labels) const
{
  Overlap overlap;
  std::vector<bool> isCounted(frames.size() > 1 ? this->Pixels : 0, false);
  for (const std::size_t frame : frames)
  {
    const std::uint16_t label = this->LabelOfSegment[this->SegmentOfFrame[frame]];
    VisitSetBits(this->Bytes, std::uint64_t(frame) * this->Pixels, this->Pixels,
      [&](std::size_t pixel)
      {
        if (labels[pixel] != 0 && !isCounted[pixel])
        {
          isCounted[pixel] = true;
          ++overlap.Voxels;
        }
        labels[pixel] = label;
      });
  }
  return overlap;
}

/// @return How many are those of no segment.
std::int64_t SegmentFrames::CopyLabels(std::size_t frame, std::uint16_t* labels) const
{
  const std::size_t first = frame * this->Pixels;
  std::int64_t undescribed = 0;
  for (std::size_t i = 0; i < this->Pixels; ++i)
  {
    const std::size_t pixel = first + i;
    labels[i] = this->Type == SegmentPixels::Bytes
      ? this->Bytes[pixel]
      : static_cast<std::uint16_t>(this->Bytes[2 * pixel] | this->Bytes[2 * pixel + 1] << 8);
    undescribed += this->IsLabel[labels[i]] ? 0 : 1;
  }
  return undescribed;
}
}
