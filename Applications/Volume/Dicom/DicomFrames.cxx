// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFrames.h"

#include "DicomAttributes.h"
#include "DicomTags.h"
#include "GdcmMessages.h"

#include <gdcmReader.h>

#include <algorithm>
#include <set>

namespace bonedecimate::volume
{
namespace
{
const gdcm::Tag ValueTransformation(0x0028, 0x9145);

/// False if it does not say where it lies.
bool TakePosition(const FrameAttributes& frame, DicomSlice& slice)
{
  const auto position = frame.Numbers(tags::PlanePosition, tags::Position, 3);
  const auto orientation = frame.Numbers(tags::PlaneOrientation, tags::Orientation, 6);
  const auto spacing = frame.Numbers(tags::PixelMeasures, tags::PixelSpacing, 2);
  if (!position || !orientation || !spacing)
  {
    return false;
  }
  std::copy_n(position->begin(), 3, slice.Position.begin());
  std::copy_n(orientation->begin(), 3, slice.AlongRow.begin());
  std::copy_n(orientation->begin() + 3, 3, slice.AlongColumn.begin());
  slice.RowDistance = (*spacing)[0];
  slice.ColumnDistance = (*spacing)[1];
  return true;
}

void TakeScale(const FrameAttributes& frame, DicomSlice& slice)
{
  const auto slope = frame.Numbers(ValueTransformation, tags::Slope, 1);
  const auto intercept = frame.Numbers(ValueTransformation, tags::Intercept, 1);
  slice.Slope = slope ? slope->front() : slice.Slope;
  slice.Intercept = intercept ? intercept->front() : slice.Intercept;
}
}

std::vector<DicomSlice> FramesOf(const DicomSlice& whole)
{
  const GdcmMessages messages;
  gdcm::Reader reader;
  reader.SetFileName(whole.File.c_str());
  if (!reader.ReadUpToTag(tags::PixelData, std::set<gdcm::Tag>()))
  {
    return {};
  }
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  const DicomItems shared(data, tags::SharedGroups);
  const DicomItems groups(data, tags::FrameGroups);
  std::vector<DicomSlice> slices;
  for (std::size_t i = 0; i < groups.Count(); ++i)
  {
    const FrameAttributes frame(groups.At(i), shared.Count() > 0 ? &shared.At(0) : nullptr);
    DicomSlice slice = whole;
    slice.Frame = static_cast<std::int64_t>(i);
    slice.Instance += "." + std::to_string(i);
    if (!TakePosition(frame, slice))
    {
      return {};
    }
    TakeScale(frame, slice);
    slices.push_back(slice);
  }
  const auto announced = static_cast<std::size_t>(std::max<std::int64_t>(whole.Frames, 0));
  for (DicomSlice& slice : slices)
  {
    slice.FramesInFile = whole.Frames;
    slice.Frames = 1; // of a slice
  }
  return slices.size() == announced ? slices : std::vector<DicomSlice>();
}
}
