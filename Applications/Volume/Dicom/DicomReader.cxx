// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomReaders.h"

#include "CurrentFile.h"
#include "DicomChoice.h"
#include "DicomFolder.h"
#include "DicomScan.h"
#include "DicomSegmentation.h"
#include "DicomSeries.h"
#include "FilePath.h"
#include "GdcmMessages.h"
#include "IntensityChecks.h"
#include "Readers/DataFile.h"

#include <gdcmImageReader.h>
#include <gdcmRescaler.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
constexpr float Air = -1000.0F; // HU

std::string FramesProblem(const std::string& file)
{
  return FilePath(file).filename().string() +
    " has several frames and does not say where each lies: convert it to one file a slice, or to "
    "NIfTI (dcm2niix)";
}

/// Names a damaged file in a folder of the slices, because it may hold a missing slice.
std::string DamageProblem(const std::vector<std::string>& damaged, const DicomSlices& taken)
{
  for (const std::string& file : damaged)
  {
    const auto parent = FilePath(file).parent_path();
    if (std::any_of(taken.begin(), taken.end(),
          [&parent](const DicomSlice& slice)
          { return FilePath(slice.File).parent_path() == parent; }))
    {
      return DamagedFileProblem(file);
    }
  }
  return std::string();
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
  SetCurrentFile(slice.File);
  reader.SetFileName(slice.File.c_str());
  if (!reader.Read() || messages.TellOfMissingPixels())
  {
    return "its pixels are damaged or truncated; copy it again";
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
    return "its pixels are damaged, truncated or compressed in a way that is not read; save it "
           "uncompressed";
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
    return "its pixels are of a type that is not read; save it uncompressed";
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
  volume.Header.Remark = series.Remark;
  volume.ReadLayer = [slices = series.Slices, next = std::size_t(0), stored = StoredImage()](
                       void* values) mutable
  {
    const DicomSlice& slice = slices[next++];
    const std::string problem = DecodeSlice(slice, stored, static_cast<float*>(values));
    return problem.empty() ? problem : FilePath(slice.File).filename().string() + ": " + problem;
  };
  return volume;
}

LayeredVolume OpenFolder(
  const std::string& folder, const SegmentSelection& selection, const std::string& series)
{
  std::vector<std::string> files = DicomFiles(folder);
  ScannedFiles scanned = ScanFiles(files, folder);
  if (scanned.Slices.empty() && scanned.Segmentations.empty())
  {
    files = DicomFilesBelow(folder);
    scanned = ScanFiles(files, folder);
  }
  const std::vector<DicomSlices> groups = GroupSeries(scanned.Slices);
  const SeriesChoice choice = ChooseSeriesOf(groups, scanned.SegmentationEntries, folder, series);
  if (!choice.Problem.empty())
  {
    return RejectedLayers(choice.Problem);
  }
  const std::size_t notImages = files.size() - scanned.Images - scanned.Segmentations.size();
  if (choice.Index >= groups.size() && !scanned.Segmentations.empty())
  {
    LayeredVolume volume =
      OpenDicomSegmentation(scanned.Segmentations[choice.Index - groups.size()], selection);
    AppendNote(volume.Header.Note, LeftAsideNote(notImages));
    return volume;
  }
  if (scanned.Slices.empty() && !scanned.FramesOfImages.empty())
  {
    return RejectedLayers(FramesProblem(scanned.FramesOfImages.front()));
  }
  DicomSeries taken = TakeSeries(groups, choice.Index, choice.IsRequested, folder);
  const std::string damage = DamageProblem(scanned.Damaged, taken.Slices);
  taken.Problem = damage.empty() ? taken.Problem : damage;
  const std::string others = LeftAsideNote(notImages);
  taken.Note += (taken.Note.empty() || others.empty() ? "" : " ") + others;
  return LayersOfSeries(taken);
}

LayeredVolume OpenFile(const std::string& file, const SegmentSelection& selection)
{
  if (!IsDicomFile(file))
  {
    return RejectedLayers("it is not a DICOM file");
  }
  const std::string folder = FilePath(file).parent_path().string();
  const ScannedFiles scanned = ScanFiles({ file }, folder);
  if (!scanned.FramesOfImages.empty())
  {
    return RejectedLayers(FramesProblem(file));
  }
  const bool isEnhanced = !scanned.Slices.empty() && scanned.Slices.front().FramesInFile > 1;
  return isEnhanced ? LayersOfSeries(TakeSeries(GroupSeries(scanned.Slices), 0, false, folder))
                    : OpenDicomSegmentation(file, selection);
}
}
}

const bonedecimate::volume::DicomReaders BoneDecimateDicomReaders = {
  bonedecimate::volume::OpenFolder, bonedecimate::volume::OpenFile
};
