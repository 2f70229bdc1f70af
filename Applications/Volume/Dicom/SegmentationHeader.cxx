// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationHeader.h"

#include "CielabColor.h"
#include "DicomAttributes.h"
#include "DicomTags.h"
#include "DicomText.h"
#include "LabelMaps/SegmentSelection.h"
#include "Readers/TextNumbers.h"

#include <algorithm>
#include <map>

namespace bonedecimate::volume
{
namespace
{
const gdcm::Tag SpacingBetweenSlices(0x0018, 0x0088);
const gdcm::Tag SamplesPerPixel(0x0028, 0x0002);
const gdcm::Tag BitsAllocated(0x0028, 0x0100);
const gdcm::Tag SegmentationType(0x0062, 0x0001);
const gdcm::Tag SegmentItems(0x0062, 0x0002);
const gdcm::Tag SegmentNumber(0x0062, 0x0004);
const gdcm::Tag SegmentLabel(0x0062, 0x0005);
const gdcm::Tag SegmentIdentificationGroup(0x0062, 0x000a);
const gdcm::Tag ReferencedSegmentNumber(0x0062, 0x000b);
const gdcm::Tag RecommendedColor(0x0062, 0x000d);

std::int64_t WordOr(std::int64_t otherwise, const gdcm::DataSet& data, const gdcm::Tag& tag)
{
  const auto words = WordsOf(data, tag, 1);
  return words ? words->front() : otherwise;
}

/// Type and size of pixels. @return What is wrong with them, or an empty text.
std::string ReadPixelType(const gdcm::DataSet& data, SegmentationHeader& header)
{
  const std::string type = TextOf(data, SegmentationType);
  const std::int64_t bits = WordOr(0, data, BitsAllocated);
  if (type == "FRACTIONAL")
  {
    return "it holds a fractional segmentation, whose voxels are probabilities; save it as a "
           "binary one";
  }
  if (type != "BINARY" && type != "LABELMAP")
  {
    return "the type of its segmentation is neither BINARY nor LABELMAP";
  }
  const bool isMap = type == "LABELMAP";
  if ((!isMap && bits != 1) || (isMap && bits != 8 && bits != 16) ||
    WordOr(1, data, SamplesPerPixel) != 1)
  {
    return "its pixels have " + std::to_string(bits) + " bits, which is not read of this type (" +
      type + ")";
  }
  if (isMap && WordOr(0, data, tags::PaddingValue) != 0)
  {
    return "the value of its background is not 0";
  }
  header.Pixels = !isMap ? SegmentPixels::Bits
    : bits == 8          ? SegmentPixels::Bytes
                         : SegmentPixels::Words;
  header.Size = { { WordOr(0, data, tags::Columns), WordOr(0, data, tags::Rows) } };
  return std::string();
}

Segment ReadSegment(const gdcm::DataSet& item, const std::string& characterSet)
{
  Segment segment;
  segment.Label = WordOr(-1, item, SegmentNumber);
  segment.Name = Utf8Of(TextOf(item, SegmentLabel), characterSet);
  const auto color = WordsOf(item, RecommendedColor, 3);
  if (color)
  {
    segment.Color = ColorOfCielab({ { (*color)[0], (*color)[1], (*color)[2] } });
  }
  return segment;
}

std::string ReadSegmentItems(const gdcm::DataSet& data, SegmentationHeader& header)
{
  const DicomItems items(data, SegmentItems);
  std::map<std::int64_t, int> uses;
  for (std::size_t i = 0; i < items.Count(); ++i)
  {
    const Segment segment = ReadSegment(items.At(i), TextOf(data, tags::CharacterSet));
    const bool isBackground = segment.Label == 0 && header.Pixels != SegmentPixels::Bits;
    if (++uses[segment.Label] > 1 || (segment.Label <= 0 && !isBackground))
    {
      return "the numbers of its segments are missing or repeat";
    }
    if (!isBackground)
    {
      header.Segments.push_back(segment);
    }
  }
  return header.Segments.empty() ? "it has no segments" : std::string();
}

/// @return False if an attribute is missing.
bool ReadPlacement(const FrameAttributes& frame, FramePlacement& placement)
{
  const auto position = frame.Numbers(tags::PlanePosition, tags::Position, 3);
  const auto orientation = frame.Numbers(tags::PlaneOrientation, tags::Orientation, 6);
  const auto spacing = frame.Numbers(tags::PixelMeasures, tags::PixelSpacing, 2);
  if (!position || !orientation || !spacing)
  {
    return false;
  }
  std::copy_n(position->begin(), 3, placement.Position.begin());
  std::copy_n(orientation->begin(), 3, placement.AlongRow.begin());
  std::copy_n(orientation->begin() + 3, 3, placement.AlongColumn.begin());
  placement.RowDistance = (*spacing)[0];
  placement.ColumnDistance = (*spacing)[1];
  return true;
}

std::size_t IndexOf(std::int64_t number, const std::vector<Segment>& segments)
{
  const auto found = std::find_if(segments.begin(), segments.end(),
    [number](const Segment& segment) { return segment.Label == number; });
  return static_cast<std::size_t>(found - segments.begin());
}

/// mm; 0 if the header does not say it. The thickness of a slice is something else.
double PlaneDistance(const FrameAttributes& frame)
{
  const auto number = frame.Numbers(tags::PixelMeasures, SpacingBetweenSlices, 1);
  return number ? number->front() : 0.0;
}

/// Segments and planes of frames. @return What is wrong with them, or an empty text.
std::string ReadFrames(const gdcm::DataSet& data, SegmentationHeader& header)
{
  const DicomItems shared(data, tags::SharedGroups);
  const DicomItems frames(data, tags::FrameGroups);
  const std::string count = TextOf(data, tags::Frames);
  if (frames.Count() == 0 && ParseWholeNumber(count).value_or(0) == 0)
  {
    return std::string(NoLabelReason) + ": it has no frames";
  }
  if (frames.Count() == 0 || ParseWholeNumber(count) != static_cast<std::int64_t>(frames.Count()))
  {
    return "it announces '" + count + "' frames and describes " + std::to_string(frames.Count());
  }
  std::vector<FramePlacement> placements(frames.Count());
  header.Frames.resize(frames.Count());
  double distance = 0.0;
  for (std::size_t i = 0; i < frames.Count(); ++i)
  {
    const FrameAttributes frame(frames.At(i), shared.Count() > 0 ? &shared.At(0) : nullptr);
    const std::string name = "its frame " + std::to_string(i + 1);
    if (!ReadPlacement(frame, placements[i]))
    {
      return name + " has no position, orientation or spacing in the patient";
    }
    if (header.Pixels == SegmentPixels::Bits)
    {
      const auto number = frame.Word(SegmentIdentificationGroup, ReferencedSegmentNumber);
      header.Frames[i].Segment = IndexOf(number.value_or(0), header.Segments);
      if (header.Frames[i].Segment == header.Segments.size())
      {
        return name + " is of a segment that the header does not describe";
      }
    }
    distance = i == 0 ? PlaneDistance(frame) : distance;
  }
  header.Grid = GridOfFrames(placements, distance, header.Size);
  for (std::size_t i = 0; header.Grid.Problem.empty() && i < frames.Count(); ++i)
  {
    header.Frames[i].Plane = header.Grid.PlaneOf[i];
  }
  return header.Grid.Problem;
}
}

SegmentationHeader ReadSegmentationHeader(const gdcm::DataSet& data)
{
  SegmentationHeader header;
  if (TextOf(data, tags::Modality) != "SEG")
  {
    header.Problem =
      "it is one DICOM file and no segmentation (SEG): give the folder of its series";
  }
  for (const auto& read : { ReadPixelType, ReadSegmentItems, ReadFrames })
  {
    header.Problem = header.Problem.empty() ? read(data, header) : header.Problem;
  }
  return header;
}
}
