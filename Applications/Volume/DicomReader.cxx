// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFolder.h"
#include "FilePath.h"

#include "DicomSegmentation.h"
#include "DicomSeries.h"
#include "DicomTags.h"
#include "GdcmMessages.h"
#include "IntensityChecks.h"
#include "TextNumbers.h"

#include <gdcmImageReader.h>
#include <gdcmRescaler.h>
#include <gdcmScanner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
const gdcm::Tag Instance(0x0008, 0x0018);
const gdcm::Tag Series(0x0020, 0x000e);
const gdcm::Tag Intercept(0x0028, 0x1052);
const gdcm::Tag Slope(0x0028, 0x1053);
const gdcm::Tag PixelRepresentation(0x0028, 0x0103);
const gdcm::Tag PaddingValue(0x0028, 0x0120);
const gdcm::Tag PaddingLimit(0x0028, 0x0121);

constexpr float Air = -1000.0F; // HU

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
  const auto value = Numbers(scanner, file, PaddingValue, 1);
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

/// Nothing for reports, localizers without a position and whatever else lies about.
std::optional<DicomSlice> ReadSlice(const gdcm::Scanner& scanner, const std::string& file)
{
  const auto position = Numbers(scanner, file, tags::Position, 3);
  const auto orientation = Numbers(scanner, file, tags::Orientation, 6);
  const auto spacing = Numbers(scanner, file, tags::PixelSpacing, 2);
  const auto rows = ParseWholeNumber(Text(scanner, file, tags::Rows));
  const auto columns = ParseWholeNumber(Text(scanner, file, tags::Columns));
  if (!position || !orientation || !spacing || !rows || !columns)
  {
    return std::nullopt;
  }
  DicomSlice slice;
  slice.File = file;
  slice.Series = Text(scanner, file, Series);
  slice.Instance = Text(scanner, file, Instance);
  slice.IsTomography = Text(scanner, file, tags::Modality) == "CT";
  slice.Frames = ParseWholeNumber(Text(scanner, file, tags::Frames)).value_or(1);
  slice.Rows = *rows;
  slice.Columns = *columns;
  std::copy_n(position->begin(), 3, slice.Position.begin());
  std::copy_n(orientation->begin(), 3, slice.AlongRow.begin());
  std::copy_n(orientation->begin() + 3, 3, slice.AlongColumn.begin());
  slice.RowDistance = (*spacing)[0];
  slice.ColumnDistance = (*spacing)[1];
  slice.Slope = NumberOr(1.0, scanner, file, Slope);
  slice.Intercept = NumberOr(0.0, scanner, file, Intercept);
  slice.Padding = PaddingOf(scanner, file);
  return slice;
}

/// What the DICOM files of a folder are.
struct ScannedFiles
{
  std::vector<DicomSlice> Slices;
  std::vector<std::string> Segmentations;
  std::vector<std::string> FramesOfImages; ///< Enhanced images: all slices in one file.
};

std::string FramesProblem(const std::string& file)
{
  return FilePath(file).filename().string() +
    " is an enhanced image, which has its slices as frames of one file and is not read: convert it "
    "to one file a slice, or to NIfTI "
    "(dcm2niix)";
}

ScannedFiles ScanFiles(const std::vector<std::string>& files)
{
  const GdcmMessages messages;
  gdcm::Scanner scanner;
  for (const gdcm::Tag& tag : { Instance, tags::Modality, Series, tags::Position, tags::Orientation,
         tags::Frames, tags::Rows, tags::Columns, tags::PixelSpacing, Intercept, Slope,
         PixelRepresentation, PaddingValue, PaddingLimit })
  {
    scanner.AddTag(tag);
  }
  scanner.Scan(files);
  ScannedFiles scanned;
  for (const std::string& file : files)
  {
    const auto slice = ReadSlice(scanner, file);
    if (Text(scanner, file, tags::Modality) == "SEG")
    {
      scanned.Segmentations.push_back(file);
    }
    else if (!slice && ParseWholeNumber(Text(scanner, file, tags::Frames)).value_or(1) > 1)
    {
      scanned.FramesOfImages.push_back(file);
    }
    else if (slice)
    {
      scanned.Slices.push_back(*slice);
    }
  }
  return scanned;
}

std::string LeftAsideNote(std::size_t others)
{
  return others == 0
    ? std::string()
    : std::to_string(others) + " DICOM files are no images with a position and were left aside.";
}

/// Where the scanner measured nothing there is air, in a CT, or the least value measured.
void ClearPadding(const DicomSlice& slice, float* values, std::size_t count)
{
  if (!slice.Padding)
  {
    return;
  }
  const auto scaled = [&slice](double stored)
  { return static_cast<float>(slice.Slope * stored + slice.Intercept); };
  const float half = 0.5F * static_cast<float>(std::abs(slice.Slope));
  const auto [first, last] = std::minmax(scaled((*slice.Padding)[0]), scaled((*slice.Padding)[1]));
  const float from = first - half;
  const float to = last + half;
  float least = slice.IsTomography ? Air : std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isPadding = values[i] > from && values[i] < to;
    least = isPadding ? least : std::min(least, values[i]);
  }
  least = least < std::numeric_limits<float>::max() ? least : 0.0F;
  std::replace_if(
    values, values + count, [from, to](float value) { return value > from && value < to; }, least);
}

/// HU of one slice, rows one after the other. Returns what went wrong, or an empty text.
std::string DecodeSlice(const DicomSlice& slice, float* values)
{
  const GdcmMessages messages;
  gdcm::ImageReader reader;
  reader.SetFileName(slice.File.c_str());
  if (!reader.Read() || messages.TellOfMissingPixels())
  {
    return "its pixels are damaged or truncated";
  }
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  const bool isGrey =
    image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::MONOCHROME1 ||
    image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::MONOCHROME2;
  if (!isGrey || format.GetSamplesPerPixel() != 1)
  {
    return "it has more than one value a pixel, a CT has one";
  }
  const std::size_t pixels = static_cast<std::size_t>(slice.Rows * slice.Columns);
  const std::size_t bytes = image.GetBufferLength();
  std::vector<char> stored(bytes);
  if (bytes != pixels * format.GetPixelSize() || !image.GetBuffer(stored.data()))
  {
    return "its pixels are damaged, truncated or compressed in a way that cannot be read";
  }
  gdcm::Rescaler rescaler;
  rescaler.SetSlope(slice.Slope);
  rescaler.SetIntercept(slice.Intercept);
  rescaler.SetPixelFormat(format);
  rescaler.SetTargetPixelType(gdcm::PixelFormat::FLOAT32);
  rescaler.SetUseTargetPixelType(true);
  if (!rescaler.Rescale(reinterpret_cast<char*>(values), stored.data(), bytes))
  {
    return "its pixels are of a type that cannot be read";
  }
  ClearPadding(slice, values, pixels);
  return std::string();
}

std::uintmax_t BytesOf(const DicomSeries& series)
{
  std::uintmax_t bytes = 0;
  for (const DicomSlice& slice : series.Slices)
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(FilePath(slice.File), error);
    bytes += error ? 0 : size;
  }
  return bytes;
}

LayeredVolume LayersOfSeries(const DicomSeries& series)
{
  if (!series.Problem.empty())
  {
    return RejectedLayers(series.Problem);
  }
  const DicomSlice& first = series.Slices.front();
  const std::array<std::int64_t, 3> size{ { first.Columns, first.Rows,
    static_cast<std::int64_t>(series.Slices.size()) } };
  const std::string sizeProblem = SizeProblem(size, 1, BytesOf(series), true);
  if (!sizeProblem.empty())
  {
    return RejectedLayers(sizeProblem);
  }
  LayeredVolume volume;
  volume.Header.Size = size;
  volume.Header.ScalarType = VTK_FLOAT; // slope and intercept need not be whole
  volume.Header.Geometry = series.Geometry;
  volume.Header.Layers = series.Layers;
  volume.Header.Note = series.Note;
  volume.ReadLayer = [slices = series.Slices, next = std::size_t(0)](void* values) mutable
  {
    const DicomSlice& slice = slices[next++];
    const std::string problem = DecodeSlice(slice, static_cast<float*>(values));
    return problem.empty() ? problem : FilePath(slice.File).filename().string() + ": " + problem;
  };
  return volume;
}
}

LayeredVolume OpenDicomFolder(const std::string& folder, const SegmentSelection& selection)
{
  std::vector<std::string> files = DicomFiles(folder);
  ScannedFiles scanned = ScanFiles(files);
  if (scanned.Slices.empty() && scanned.Segmentations.empty())
  {
    files = DicomFilesBelow(folder);
    scanned = ScanFiles(files);
  }
  const std::size_t segmentations = scanned.Segmentations.size();
  if (scanned.Slices.empty() && segmentations > 1)
  {
    return RejectedLayers("it holds " + std::to_string(segmentations) +
      " DICOM segmentations; give the file of one of them");
  }
  if (scanned.Slices.empty() && segmentations == 1)
  {
    LayeredVolume volume = OpenDicomSegmentation(scanned.Segmentations.front(), selection);
    AppendNote(volume.Header.Note, LeftAsideNote(files.size() - 1));
    return volume;
  }
  if (scanned.Slices.empty() && !scanned.FramesOfImages.empty())
  {
    return RejectedLayers(FramesProblem(scanned.FramesOfImages.front()));
  }
  DicomSeries series = LargestSeries(scanned.Slices, folder);
  const std::string others = LeftAsideNote(files.size() - scanned.Slices.size());
  series.Note += (series.Note.empty() || others.empty() ? "" : " ") + others;
  return LayersOfSeries(series);
}

LayeredVolume OpenDicomFile(const std::string& file, const SegmentSelection& selection)
{
  if (!IsDicomFile(file))
  {
    return RejectedLayers("it is not a DICOM file");
  }
  const ScannedFiles scanned = ScanFiles({ file });
  return scanned.FramesOfImages.empty() ? OpenDicomSegmentation(file, selection)
                                        : RejectedLayers(FramesProblem(file));
}
}
