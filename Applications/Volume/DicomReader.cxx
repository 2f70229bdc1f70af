// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFolder.h"
#include "FilePath.h"

#include "DataFile.h"
#include "DicomFrames.h"
#include "DicomSegmentation.h"
#include "DicomSeries.h"
#include "DicomTags.h"
#include "GdcmMessages.h"
#include "IntensityChecks.h"
#include "MemoryCap.h"
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
const gdcm::Tag ClassOfImage(0x0008, 0x0016);
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

/// What the DICOM files of a folder are.
struct ScannedFiles
{
  std::vector<DicomSlice> Slices;
  std::vector<std::string> Segmentations;
  std::vector<std::string>
    FramesOfImages;       ///< Files of several frames that do not say where each lies.
  std::size_t Images = 0; ///< Files that have slices.
};

std::string FramesProblem(const std::string& file)
{
  return FilePath(file).filename().string() +
    " has several frames and does not say where each lies: convert it to one file a slice, or to "
    "NIfTI (dcm2niix)";
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

ScannedFiles ScanFiles(const std::vector<std::string>& files)
{
  const MemoryCap cap(MemoryForFiles(LargestOf(files)));
  const GdcmMessages messages;
  gdcm::Scanner scanner;
  for (const gdcm::Tag& tag : { ClassOfImage, Instance, tags::Modality, Series, tags::Position,
         tags::Orientation, tags::Frames, tags::Rows, tags::Columns, tags::PixelSpacing,
         tags::Intercept, tags::Slope, PixelRepresentation, PaddingValue, PaddingLimit })
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
  const float one = scaled((*slice.Padding)[0]);
  const float other = scaled((*slice.Padding)[1]);
  const float from = std::min(one, other) - half;
  const float to = std::max(one, other) + half;
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

/// The stored values of a file, of all its frames.
struct StoredImage
{
  std::string File;
  std::vector<char> Values;
  gdcm::PixelFormat Format;
};

/// @return What went wrong, or an empty text.
std::string ReadStored(const DicomSlice& slice, StoredImage& stored)
{
  const GdcmMessages messages;
  gdcm::ImageReader reader;
  reader.SetFileName(slice.File.c_str());
  if (!reader.Read() || messages.TellOfMissingPixels())
  {
    return "its pixels are damaged or truncated";
  }
  const gdcm::Image& image = reader.GetImage();
  stored.Format = image.GetPixelFormat();
  const bool isGrey =
    image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::MONOCHROME1 ||
    image.GetPhotometricInterpretation() == gdcm::PhotometricInterpretation::MONOCHROME2;
  if (!isGrey || stored.Format.GetSamplesPerPixel() != 1)
  {
    return "it has more than one value a pixel, a CT has one";
  }
  const auto pixels = static_cast<std::size_t>(slice.Rows * slice.Columns * slice.FramesInFile);
  const std::size_t bytes = image.GetBufferLength();
  stored.Values.resize(bytes);
  if (bytes != pixels * stored.Format.GetPixelSize() || !image.GetBuffer(stored.Values.data()))
  {
    return "its pixels are damaged, truncated or compressed in a way that cannot be read";
  }
  stored.File = slice.File;
  return std::string();
}

/// HU of one slice, rows one after the other. Returns what went wrong, or an empty text.
std::string DecodeSlice(const DicomSlice& slice, StoredImage& stored, float* values)
{
  const std::string problem = stored.File == slice.File ? std::string() : ReadStored(slice, stored);
  if (!problem.empty())
  {
    return problem;
  }
  const auto pixels = static_cast<std::size_t>(slice.Rows * slice.Columns);
  const std::size_t bytes = pixels * stored.Format.GetPixelSize();
  gdcm::Rescaler rescaler;
  rescaler.SetSlope(slice.Slope);
  rescaler.SetIntercept(slice.Intercept);
  rescaler.SetPixelFormat(stored.Format);
  rescaler.SetTargetPixelType(gdcm::PixelFormat::FLOAT32);
  rescaler.SetUseTargetPixelType(true);
  const char* const first = stored.Values.data() + static_cast<std::size_t>(slice.Frame) * bytes;
  if (!rescaler.Rescale(reinterpret_cast<char*>(values), first, bytes))
  {
    return "its pixels are of a type that cannot be read";
  }
  ClearPadding(slice, values, pixels);
  return std::string();
}

std::uintmax_t BytesOf(const DicomSeries& series)
{
  std::uintmax_t bytes = 0;
  const std::string* last = nullptr;
  for (const DicomSlice& slice : series.Slices)
  {
    std::error_code error;
    const bool isNew = !last || *last != slice.File; // frames of one file follow each other
    const std::uintmax_t size = std::filesystem::file_size(FilePath(slice.File), error);
    bytes += error || !isNew ? 0 : size;
    last = &slice.File;
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
  volume.ReadLayer = [slices = series.Slices, next = std::size_t(0), stored = StoredImage()](
                       void* values) mutable
  {
    const DicomSlice& slice = slices[next++];
    const std::string problem = DecodeSlice(slice, stored, static_cast<float*>(values));
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
  const std::string others = LeftAsideNote(files.size() - scanned.Images);
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
  if (!scanned.FramesOfImages.empty())
  {
    return RejectedLayers(FramesProblem(file));
  }
  const bool isEnhanced = !scanned.Slices.empty() && scanned.Slices.front().FramesInFile > 1;
  return isEnhanced
    ? LayersOfSeries(LargestSeries(scanned.Slices, FilePath(file).parent_path().string()))
    : OpenDicomSegmentation(file, selection);
}
}
