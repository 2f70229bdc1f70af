// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilePath.h"
#include "ImageFiles.h"

#include "Base/Text.h"
#include "DataFile.h"
#include "HeaderUnit.h"
#include "ItkImage.h"
#include "StoredVoxels.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
/// The lines of a header up to ElementDataFile, the last one; empty if there is no such line.
std::string HeaderText(const std::string& path)
{
  constexpr std::size_t longest = std::size_t(1) << 22;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::string line;
  while (text.size() < longest && std::getline(file, line))
  {
    text += line + "\n";
    if (LowerCase(Trimmed(line)).compare(0, 15, "elementdatafile") == 0)
    {
      return text;
    }
  }
  return std::string();
}

std::string FieldOf(const std::string& header, const std::string& key)
{
  std::istringstream lines(header);
  std::string line;
  while (std::getline(lines, line))
  {
    const std::size_t position = line.find('=');
    if (position != std::string::npos && LowerCase(Trimmed(line.substr(0, position))) == key)
    {
      return Trimmed(line.substr(position + 1));
    }
  }
  return std::string();
}

/// MetaIO trusts any number of dimensions, and takes the last of several.
std::string DimensionsProblem(const std::string& header)
{
  std::istringstream lines(header);
  std::string line;
  int count = 0;
  while (std::getline(lines, line))
  {
    const std::string key = LowerCase(Trimmed(line.substr(0, line.find('='))));
    count += key == "ndims" || key == "dimsize" ? 1 : 0;
  }
  const std::string text = FieldOf(header, "ndims");
  if (count != 2 || ParseWholeNumber(text).value_or(0) != 3)
  {
    return count == 2
      ? "its NDims is " + text.substr(0, 20) + ", only volumes of three dimensions are read"
      : "it does not have NDims and DimSize once each";
  }
  return std::string();
}

/// MetaIO takes numbers that it cannot read for zeros.
std::string NumbersProblem(const std::string& header)
{
  static const std::vector<std::pair<const char*, std::size_t>> fields{ { "DimSize", 3 },
    { "ElementSpacing", 3 }, { "ElementSize", 3 }, { "Offset", 3 }, { "Position", 3 },
    { "Origin", 3 }, { "TransformMatrix", 9 }, { "Rotation", 9 }, { "Orientation", 9 } };
  for (const auto& [name, count] : fields)
  {
    const std::string text = FieldOf(header, LowerCase(name));
    const auto numbers = ParseNumbers(text);
    if (!text.empty() && (!numbers || numbers->size() != count))
    {
      return "its " + std::string(name) + " is not " + std::to_string(count) + " numbers";
    }
  }
  return std::string();
}

/// What of the format is not read, in words; empty if all is.
std::string DataFileProblem(const std::string& header, const DataFile& data)
{
  const std::string name = LowerCase(FieldOf(header, "elementdatafile"));
  const auto packed = ParseWholeNumber(FieldOf(header, "compresseddatasize"));
  if (name.compare(0, 4, "list") == 0 || name.find('%') != std::string::npos)
  {
    return "its voxels lie in several files; save it as one .mha";
  }
  if (SizeOfFile(data.Path) == 0)
  {
    return "the file of its voxels, " + FilePath(data.Path).filename().string() +
      ", cannot be read";
  }
  // Without it MetaIO takes the whole file.
  if (data.IsCompressed && (packed ? *packed <= 0 : name == "local"))
  {
    return "its header does not say how many bytes its compressed voxels have";
  }
  return std::string();
}

DataFile MetaData(const std::string& path, const std::string& header)
{
  const std::string name = FieldOf(header, "elementdatafile");
  const std::string compressed = LowerCase(FieldOf(header, "compresseddata"));
  const bool isCompressed = !compressed.empty() && (compressed[0] == 't' || compressed[0] == '1');
  const auto skipped = ParseWholeNumber(FieldOf(header, "headersize")).value_or(0);
  DataFile data = LowerCase(name) == "local"
    ? DataFileBeside(path, FilePath(path).filename().string(), header.size(), isCompressed)
    : DataFileBeside(
        path, name, static_cast<std::uint64_t>(std::max<std::int64_t>(skipped, 0)), isCompressed);
  const auto packed = ParseWholeNumber(FieldOf(header, "compresseddatasize"));
  if (isCompressed && packed && *packed > 0)
  {
    data.Bytes = std::min(data.Bytes, static_cast<std::uint64_t>(*packed));
  }
  return data;
}

/// Whether there is nothing else in the file of the voxels, where it begins.
bool IsPlain(const std::string& header)
{
  return ParseWholeNumber(FieldOf(header, "headersize")).value_or(0) == 0;
}

ByteOrder OrderOf(const std::string& header)
{
  const std::string key = FieldOf(header, "elementbyteordermsb");
  const std::string order =
    LowerCase(key.empty() ? FieldOf(header, "binarydatabyteordermsb") : key);
  return !order.empty() && (order[0] == 't' || order[0] == '1') ? ByteOrder::Big
                                                                : ByteOrder::Little;
}
}

bool MetaImageHasSpacing(const std::string& path)
{
  const std::string text = HeaderText(path);
  const auto numbers =
    ParseNumbers(FieldOf(text, "elementspacing") + " " + FieldOf(text, "elementsize"));
  return text.empty() || !numbers || // which is a problem of its own
    std::any_of(
      numbers->begin(), numbers->end(), [](double value) { return std::isfinite(value); });
}

LayeredVolume OpenMetaImage(const std::string& path)
{
  const std::string text = HeaderText(path);
  if (text.empty())
  {
    return RejectedLayers("it has no header of a MetaImage");
  }
  const std::string numbers = FirstOf({ DimensionsProblem(text), NumbersProblem(text) });
  if (!numbers.empty())
  {
    return RejectedLayers(numbers);
  }
  ItkImage image(ItkImage::Format::MetaImage, path);
  const ItkHeader& header = image.GetHeader();
  const DataFile data = MetaData(path, text);
  const HeaderUnit unit =
    UnitOf(FieldOf(text, "distanceunits")); // MetaIO passes over others than mm, um and cm
  const std::string problem = FirstOf(
    { header.Problem, header.IsText ? "its voxels are text; save them as binary numbers" : "",
      UnitProblem(unit), ComponentsProblem(header), DataFileProblem(text, data) });
  const std::string dataProblem = problem.empty() ? DataProblem(header, data) : problem;
  if (!dataProblem.empty())
  {
    return RejectedLayers(dataProblem);
  }
  LayeredVolume volume =
    IsPlain(text) ? StoredLayers(header, data, OrderOf(text)) : LayersOf(image.ReadVolume());
  volume.Header.Geometry = InMillimeters(volume.Header.Geometry, unit);
  volume.Header.Note = UnitNote(unit);
  return volume;
}
}
