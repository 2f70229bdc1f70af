// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomScan.h"

#include "CurrentFile.h"
#include "DicomFrames.h"
#include "DicomTags.h"
#include "DicomText.h"
#include "FilePath.h"
#include "GdcmMessages.h"
#include "MemoryCap.h"
#include "Readers/DataFile.h"
#include "Readers/TextNumbers.h"

#include <gdcmScanner.h>

#include <algorithm>
#include <array>
#include <optional>

namespace bonedecimate::volume
{
namespace
{
const gdcm::Tag Instance(0x0008, 0x0018);
const gdcm::Tag Series(0x0020, 0x000e);
const gdcm::Tag SeriesDescription(0x0008, 0x103e);
const gdcm::Tag ClassOfImage(0x0008, 0x0016);
const gdcm::Tag PixelRepresentation(0x0028, 0x0103);
const gdcm::Tag PaddingLimit(0x0028, 0x0121);

std::string Text(const gdcm::Scanner& scanner, const std::string& file, const gdcm::Tag& tag)
{
  const char* value = scanner.GetValue(file.c_str(), tag);
  return value ? Trimmed(value) : std::string();
}

/// Exactly so many numbers, or none.
std::optional<std::vector<double>> Numbers(
  const gdcm::Scanner& scanner, const std::string& file, const gdcm::Tag& tag, std::size_t count)
{
  auto numbers = ParseNumbers(Text(scanner, file, tag));
  return numbers && numbers->size() == count ? numbers : std::nullopt;
}

double NumberOr(
  double otherwise, const gdcm::Scanner& scanner, const std::string& file, const gdcm::Tag& tag)
{
  const auto number = Numbers(scanner, file, tag, 1);
  return number ? number->front() : otherwise;
}

/// Stored values, the smaller first.
std::optional<std::array<double, 2>> PaddingOf(
  const gdcm::Scanner& scanner, const std::string& file)
{
  const auto value = Numbers(scanner, file, tags::PaddingValue, 1);
  if (!value)
  {
    return std::nullopt;
  }
  constexpr double beyond = 65536.0;
  const bool isSigned = Text(scanner, file, PixelRepresentation) == "1";
  // The type of the attribute is that of the pixels, which not every writer says.
  const auto stored = [isSigned](double number)
  { return isSigned && number >= beyond / 2.0 ? number - beyond : number; };
  const double first = stored(value->front());
  const double last = stored(NumberOr(value->front(), scanner, file, PaddingLimit));
  return std::array<double, 2>{ { std::min(first, last), std::max(first, last) } };
}

std::string DescriptionOf(const gdcm::Scanner& scanner, const std::string& file)
{
  return Utf8Of(Text(scanner, file, SeriesDescription), Text(scanner, file, tags::CharacterSet));
}

/// What does not say where it lies; of several frames what all have. Nothing for what is no image.
std::optional<DicomSlice> ReadImage(const gdcm::Scanner& scanner, const std::string& file)
{
  const auto rows = ParseWholeNumber(Text(scanner, file, tags::Rows));
  const auto columns = ParseWholeNumber(Text(scanner, file, tags::Columns));
  if (!rows || !columns)
  {
    return std::nullopt;
  }
  DicomSlice slice;
  slice.File = file;
  slice.Series = Text(scanner, file, Series);
  slice.Description = DescriptionOf(scanner, file);
  slice.Instance = Text(scanner, file, Instance);
  slice.IsTomography = Text(scanner, file, tags::Modality) == "CT";
  slice.Frames = ParseWholeNumber(Text(scanner, file, tags::Frames)).value_or(1);
  slice.Rows = *rows;
  slice.Columns = *columns;
  slice.Slope = NumberOr(1.0, scanner, file, tags::Slope);
  slice.Intercept = NumberOr(0.0, scanner, file, tags::Intercept);
  slice.Padding = PaddingOf(scanner, file);
  return slice;
}

/// Nothing for reports, localizers without a position and whatever else lies about.
std::optional<DicomSlice> ReadSlice(const gdcm::Scanner& scanner, const std::string& file)
{
  const auto position = Numbers(scanner, file, tags::Position, 3);
  const auto orientation = Numbers(scanner, file, tags::Orientation, 6);
  const auto spacing = Numbers(scanner, file, tags::PixelSpacing, 2);
  std::optional<DicomSlice> slice = ReadImage(scanner, file);
  if (!position || !orientation || !spacing || !slice)
  {
    return std::nullopt;
  }
  std::copy_n(position->begin(), 3, slice->Position.begin());
  std::copy_n(orientation->begin(), 3, slice->AlongRow.begin());
  std::copy_n(orientation->begin() + 3, 3, slice->AlongColumn.begin());
  slice->RowDistance = (*spacing)[0];
  slice->ColumnDistance = (*spacing)[1];
  return slice;
}

/// Bytes.
std::uint64_t LargestOf(const std::vector<std::string>& files)
{
  std::uint64_t largest = 0;
  for (const std::string& file : files)
  {
    largest = std::max(largest, SizeOfFile(file));
  }
  return largest;
}

/// Whatever its modality is called.
bool IsOfSegments(const gdcm::Scanner& scanner, const std::string& file)
{
  const std::string kind = Text(scanner, file, ClassOfImage);
  return kind == "1.2.840.10008.5.1.4.1.1.66.4" || kind == "1.2.840.10008.5.1.4.1.1.66.7";
}

/// An image that lacks what all have, because the file ends before, or what is no DICOM file after
/// its first bytes.
bool IsDamaged(const gdcm::Scanner& scanner, const std::string& file)
{
  const std::string kind = Text(scanner, file, ClassOfImage);
  const bool isSlice = kind == "1.2.840.10008.5.1.4.1.1.2" || kind == "1.2.840.10008.5.1.4.1.1.4";
  const bool hasFrames = !Text(scanner, file, tags::Frames).empty();
  return !scanner.IsKey(file.c_str()) ||
    (isSlice && !hasFrames &&
      (Text(scanner, file, tags::Columns).empty() ||
        Text(scanner, file, tags::PixelSpacing).empty()));
}

/// Notes what one file is. @param folder The folder that is read.
void AddFile(const gdcm::Scanner& scanner, const std::string& file, const std::string& folder,
  ScannedFiles& scanned)
{
  const auto slice = ReadSlice(scanner, file);
  if (IsDamaged(scanner, file))
  {
    scanned.Damaged.push_back(file);
  }
  else if (Text(scanner, file, tags::Modality) == "SEG")
  {
    const std::string name = FilePath(file).lexically_relative(FilePath(folder)).generic_string();
    scanned.Segmentations.push_back(file);
    scanned.SegmentationEntries.push_back(
      { Text(scanner, file, Series), DescriptionOf(scanner, file), "segmentation " + name });
  }
  else if (slice)
  {
    scanned.Slices.push_back(*slice);
    ++scanned.Images;
  }
  else if (const auto image = ReadImage(scanner, file);
           image && image->Frames > 1 && !IsOfSegments(scanner, file))
  {
    const std::vector<DicomSlice> frames = FramesOf(*image);
    scanned.Slices.insert(scanned.Slices.end(), frames.begin(), frames.end());
    scanned.Images += frames.empty() ? 0 : 1;
    if (frames.empty())
    {
      scanned.FramesOfImages.push_back(file);
    }
  }
}
}

ScannedFiles ScanFiles(const std::vector<std::string>& files, const std::string& folder)
{
  const MemoryCap cap(MemoryForFiles(LargestOf(files)));
  const GdcmMessages messages;
  gdcm::Scanner scanner;
  for (const gdcm::Tag& tag : { ClassOfImage, Instance, tags::Modality, Series, SeriesDescription,
         tags::CharacterSet, tags::Position, tags::Orientation, tags::Frames, tags::Rows,
         tags::Columns, tags::PixelSpacing, tags::Intercept, tags::Slope, PixelRepresentation,
         tags::PaddingValue, PaddingLimit })
  {
    scanner.AddTag(tag);
  }
  ScannedFiles scanned;
  for (const std::string& file : files)
  {
    // A library that ends the process leaves the name of the file behind.
    SetCurrentFile(files.size() > 1 ? file : std::string());
    scanner.Scan({ file });
    AddFile(scanner, file, folder, scanned);
  }
  SetCurrentFile(std::string());
  return scanned;
}
}
