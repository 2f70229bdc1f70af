// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentFrames.h
 * @brief The pixels of a DICOM segmentation as labels, one plane after the other.
 */
#ifndef BoneDecimate_Applications_SegmentFrames_h
#define BoneDecimate_Applications_SegmentFrames_h

#include "LabelMaps/Segmentation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// What the bytes of its pixels mean.
enum class SegmentPixels
{
  /// Whether it is in the segment of the frame; eight to a byte, the first one lowest, frames
  /// without a gap.
  Bits,
  Bytes, ///< The label, 8 bits.
  Words  ///< The label, 16 bits, little-endian.
};

/// How many bytes so many pixels take.
std::uint64_t BytesOfPixels(std::uint64_t pixels, SegmentPixels type);

struct SegmentFrame
{
  std::size_t Segment = 0; ///< Index, of bits.
  std::int64_t Plane = 0;
};

class SegmentFrames
{
public:
  /**
   * @param bytes Pixels of all frames, one after the other: BytesOfPixels() at least.
   * @param size Columns and rows.
   */
  SegmentFrames(SegmentPixels type, std::vector<unsigned char> bytes,
    const std::array<std::int64_t, 2>& size, const std::vector<Segment>& segments);

  /// Assigns the frames to planes.
  /// @param isChosen For each segment, whether it is selected; empty: all are.
  /// @return Why the frames give no planes of labels; empty if they do.
  std::string Arrange(const std::vector<SegmentFrame>& frames, std::int64_t planes,
    const std::vector<bool>& isChosen = {});

  /// Writes a label for each pixel of the plane, 0 where it has no frame. Of several segments the
  /// last one counts.
  Overlap Combine(std::int64_t plane, std::uint16_t* labels) const;

private:
  Overlap CombineBits(const std::vector<std::size_t>& frames, std::uint16_t* labels) const;
  std::int64_t CopyLabels(std::size_t frame, std::uint16_t* labels) const;

  SegmentPixels Type;
  std::vector<unsigned char> Bytes;
  std::size_t Pixels; ///< Number of pixels of a frame.
  std::vector<std::uint16_t> LabelOfSegment;
  std::vector<bool> IsLabel;
  std::vector<std::size_t> SegmentOfFrame;
  /// Frames of each plane, in the order of segments.
  std::vector<std::vector<std::size_t>> FramesOfPlane;
};
}

#endif
