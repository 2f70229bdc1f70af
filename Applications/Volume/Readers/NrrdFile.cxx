// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilePath.h"
#include "ImageFiles.h"

#include "Base/Text.h"
#include "DataFile.h"
#include "HeaderUnit.h"
#include "IntensityChecks.h"
#include "ItkImage.h"
#include "LabelMaps/Segmentation.h"
#include "NrrdText.h"
#include "StoredVoxels.h"

#include <NrrdIO.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
/// A header with its data file open.
class NrrdHeader
{
public:
  explicit NrrdHeader(const std::string& path)
  {
    nrrdIoStateSet(this->State, nrrdIoStateSkipData, 1);
    nrrdIoStateSet(this->State, nrrdIoStateKeepNrrdDataFileOpen, 1);
    this->IsLoaded = nrrdLoad(this->Header, path.c_str(), this->State) == 0;
    if (!this->IsLoaded)
    {
      std::free(biffGetDone(NRRD));
    }
  }

  ~NrrdHeader()
  {
    if (this->State->dataFile)
    {
      std::fclose(this->State->dataFile);
    }
    nrrdIoStateNix(this->State);
    nrrdNix(this->Header);
  }

  NrrdHeader(const NrrdHeader&) = delete;
  NrrdHeader& operator=(const NrrdHeader&) = delete;

  /// What of the format is not read, in words; empty if all is.
  std::string Problem() const
  {
    if (!this->IsLoaded)
    {
      return "its header is damaged, or the file of its voxels is not there";
    }
    if (!this->State->dataFile)
    {
      return "its voxels lie in several files; save it as one .nrrd";
    }
    if (this->State->encoding == nrrdEncodingBzip2)
    {
      return "its voxels are packed by bzip2, which is not read; save it with gzip";
    }
    const auto spaces = { nrrdSpaceUnknown, nrrdSpaceRightAnteriorSuperior,
      nrrdSpaceLeftAnteriorSuperior, nrrdSpaceLeftPosteriorSuperior, nrrdSpaceScannerXYZ,
      nrrdSpace3DRightHanded };
    const bool isKnown =
      std::find(spaces.begin(), spaces.end(), this->Header->space) != spaces.end();
    return isKnown ? UnitProblem(this->Unit()) : "its space is not RAS, LAS or LPS";
  }

  unsigned int Dimensions() const { return this->Header->dim; }

  /// Unit of the axes of the space and of those that have a spacing; an unknown one if they have
  /// several.
  HeaderUnit Unit() const
  {
    std::vector<const char*> texts(
      this->Header->spaceUnits, this->Header->spaceUnits + this->Header->spaceDim);
    for (unsigned int i = 0; i < this->Header->dim; ++i)
    {
      const NrrdAxisInfo& axis = this->Header->axis[i];
      if (!std::isnan(axis.spacing))
      {
        texts.push_back(axis.units);
      }
    }
    HeaderUnit unit;
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
      const HeaderUnit ofAxis = UnitOf(texts[i] ? texts[i] : "");
      const bool isSame = i == 0 || ofAxis.Name == unit.Name;
      unit = isSame ? ofAxis : HeaderUnit{ unit.Name + ", " + ofAxis.Name, 0.0 };
    }
    return unit;
  }

  /// The voxels that the header refers to. Requires a header without a problem.
  DataFile Data(const std::string& path) const
  {
    const std::string name = this->State->dataFNArr->len == 0 ? FilePath(path).filename().string()
                                                              : this->State->dataFN[0];
    const long begin = std::max(std::ftell(this->State->dataFile), 0L);
    DataFile data = DataFileBeside(
      path, name, static_cast<std::uint64_t>(begin), this->State->encoding->isCompression != 0);
    // The library has skipped lines, and bytes of voxels that are not compressed.
    data.Skipped =
      data.IsCompressed ? static_cast<std::uint64_t>(std::max(this->State->byteSkip, 0L)) : 0;
    return data;
  }

  /// The voxels behind a header of so many bytes in the same file.
  DataFile DataBehind(const std::string& path, std::uint64_t header) const
  {
    return DataFileBeside(
      path, FilePath(path).filename().string(), header, this->State->encoding->isCompression != 0);
  }

  /// Whether the voxels are numbers one after the other, where the file's data begin.
  bool IsPlain() const
  {
    return this->State->encoding == nrrdEncodingRaw || this->State->encoding == nrrdEncodingGzip;
  }

  ByteOrder Order() const
  {
    return this->State->endian == airEndianBig ? ByteOrder::Big : ByteOrder::Little;
  }

  /// From what ITK makes of it to mm in LPS.
  void ConvertToPatient(VolumeGeometry& geometry) const
  {
    this->CorrectSpace(geometry);
    geometry = InMillimeters(geometry, this->Unit());
  }

private:
  /// ITK mirrored x of a file in LAS instead of y before
  /// https://github.com/InsightSoftwareConsortium/ITK/pull/5224.
  void CorrectSpace(VolumeGeometry& geometry) const
  {
    if (this->Header->space == nrrdSpaceLeftAnteriorSuperior && this->HasMirroredX(geometry))
    {
      for (Vector3* vector :
        { &geometry.Origin, &geometry.Steps[0], &geometry.Steps[1], &geometry.Steps[2] })
      {
        (*vector)[0] = -(*vector)[0];
        (*vector)[1] = -(*vector)[1];
      }
    }
  }

  /// Whether x of the steps has the opposite sign of that in the file, where it is largest.
  bool HasMirroredX(const VolumeGeometry& geometry) const
  {
    double largest = 0.0;
    std::size_t step = 0;
    for (unsigned int axis = 0; axis < this->Header->dim && step < 3; ++axis)
    {
      const double x = this->Header->axis[axis].spaceDirection[0];
      if (!std::isnan(x)) // axes of values and layers have no direction
      {
        const double product = x * geometry.Steps[step++][0];
        largest = std::abs(product) > std::abs(largest) ? product : largest;
      }
    }
    return largest < 0.0;
  }

  Nrrd* Header = nrrdNew();
  NrrdIoState* State = nrrdIoStateNew();
  bool IsLoaded = false;
};

/// Error message for voxels as text. The library would search other text for blanks without end.
std::string TextProblem(const ItkHeader& header, const DataFile& data)
{
  constexpr int longest = 64; // characters of a number
  const std::string problem = SizeProblem(header.Size, 1, data.Bytes, false);
  std::ifstream file(data.Path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(data.Begin));
  const std::string inNumbers = "0123456789+-.eEinfaINFA";
  const std::string between = " \t\r\n,";
  int length = 0;
  for (char c = '\0'; problem.empty() && file.get(c);)
  {
    const bool isBetween = between.find(c) != std::string::npos;
    length = isBetween ? 0 : length + 1;
    if (length > longest || (!isBetween && inNumbers.find(c) == std::string::npos))
    {
      return "its voxels are text by its header, but not all of them are numbers";
    }
  }
  return problem;
}

/// Rejects a data file that is not regular: the library would open it, whatever it is.
std::string DataFileProblem(const std::string& path, const NrrdText& text)
{
  const std::string name = text.DataFile();
  const bool isOne =
    LowerCase(name).compare(0, 4, "list") != 0 && name.find('%') == std::string::npos;
  const std::string voxels = (FilePath(path).parent_path() / FilePath(name)).string();
  std::error_code error;
  if (name.empty() || !isOne || std::filesystem::is_regular_file(FilePath(voxels), error))
  {
    return isOne ? std::string() : "its voxels lie in several files; save it as one .nrrd";
  }
  return "the file of its voxels, " + name + ", is not there or is no regular file";
}
}

bool NrrdHasSpacing(const std::string& path)
{
  const NrrdText text = ReadNrrdText(path);
  const bool isHeader =
    !text.FieldOf("sizes").empty() && (text.IsEnded || !text.DataFile().empty());
  return !isHeader || text.HasSpacing(); // without a header it has a problem of its own
}

LayeredVolume OpenNrrd(const std::string& path, const SegmentSelection& selection)
{
  const NrrdText text = ReadNrrdText(path);
  const NrrdHeaderFile file(path, text);
  const std::string inText = FirstOf({ file.GetProblem(), DataFileProblem(path, text) });
  if (!inText.empty())
  {
    return RejectedLayers(inText);
  }
  const NrrdHeader nrrd(file.GetPath());
  if (!nrrd.Problem().empty())
  {
    return RejectedLayers(nrrd.Problem());
  }
  const bool isInFile = text.DataFile().empty();
  const DataFile data =
    file.IsShortened() && isInFile ? nrrd.DataBehind(path, text.Bytes) : nrrd.Data(file.GetPath());
  ItkImage image(ItkImage::Format::Nrrd, file.GetPath());
  const ItkHeader& header = image.GetHeader();
  const std::vector<Segment> segments =
    ReadSegments([&image](const std::string& key) { return image.GetText(key); });
  const bool hasLayers = !segments.empty() && header.HasLayers;
  const std::string problem =
    FirstOf({ header.Problem, hasLayers ? std::string() : ComponentsProblem(header) });
  if (!header.Problem.empty() && nrrd.Dimensions() > 3)
  {
    return RejectedLayers("it has " + std::to_string(nrrd.Dimensions()) +
      " dimensions, only volumes of three are read");
  }
  const std::string dataProblem = !problem.empty() ? problem
    : header.IsText                                ? TextProblem(header, data)
                                                   : DataProblem(header, data);
  if (!dataProblem.empty())
  {
    return RejectedLayers(dataProblem);
  }
  if (!hasLayers && nrrd.IsPlain())
  {
    LayeredVolume layers = StoredLayers(header, data, nrrd.Order());
    nrrd.ConvertToPatient(layers.Header.Geometry);
    AddLabelFields(segments, layers.Header.Fields);
    AppendNote(layers.Header.Note, UnitNote(nrrd.Unit()));
    return layers;
  }
  Volume volume = image.ReadVolume();
  nrrd.ConvertToPatient(volume.Geometry);
  LayeredVolume layers = volume.Image && hasLayers
    ? LayersOf(CombinedLayers(volume, segments, selection))
    : LayersOf(volume);
  if (!hasLayers)
  {
    AddLabelFields(segments, layers.Header.Fields);
  }
  AppendNote(layers.Header.Note, UnitNote(nrrd.Unit()));
  return layers;
}
}
