// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NrrdHeader.h"

#include "HeaderText.h"
#include "Options/Text.h"

#include <algorithm>
#include <map>

namespace bonedecimate::volume
{
namespace
{
/// All the names the format has for them.
int ScalarType(const std::string& name)
{
  static const std::map<std::string, int> types{ { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT },
    { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG },
    { "signed long long", VTK_LONG_LONG }, { "signed long long int", VTK_LONG_LONG },
    { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  const auto found = types.find(name);
  return found == types.end() ? VTK_VOID : found->second;
}

/// Per axis, what turns the file's space into LPS; empty if its name is not known.
std::vector<double> SignsToLps(const std::string& space)
{
  static const std::map<std::string, std::vector<double>> spaces{ { "", { 1.0, 1.0, 1.0 } },
    { "lps", { 1.0, 1.0, 1.0 } }, { "left-posterior-superior", { 1.0, 1.0, 1.0 } },
    { "ras", { -1.0, -1.0, 1.0 } }, { "right-anterior-superior", { -1.0, -1.0, 1.0 } },
    { "las", { 1.0, -1.0, 1.0 } }, { "left-anterior-superior", { 1.0, -1.0, 1.0 } },
    { "scanner-xyz", { 1.0, 1.0, 1.0 } }, { "3d-right-handed", { 1.0, 1.0, 1.0 } } };
  const auto found = spaces.find(space);
  return found == spaces.end() ? std::vector<double>() : found->second;
}

bool AreMillimeters(const std::string& units)
{
  static const std::vector<std::string> known{ "\"millimeters\"", "\"millimeter\"", "\"mm\"",
    "\"\"" };
  std::string rest = LowerCase(units);
  for (const std::string& unit : known)
  {
    std::size_t position = rest.find(unit);
    while (position != std::string::npos)
    {
      rest.erase(position, unit.size());
      position = rest.find(unit);
    }
  }
  return Trimmed(rest).empty();
}

/// Three vectors, or three spacings along the axes of the space.
std::vector<double> Directions(const HeaderText& header)
{
  const std::string vectors = header.Value({ "space directions" });
  if (!vectors.empty())
  {
    return ParseNumbers(vectors).value_or(std::vector<double>());
  }
  const auto spacings = header.Fields.count("spacings") > 0
    ? ParseNumbers(header.Value({ "spacings" })).value_or(std::vector<double>())
    : std::vector<double>{ 1.0, 1.0, 1.0 };
  return spacings.size() != 3
    ? std::vector<double>()
    : std::vector<double>{ spacings[0], 0.0, 0.0, 0.0, spacings[1], 0.0, 0.0, 0.0, spacings[2] };
}

std::string ReadGeometry(const HeaderText& header, VolumeGeometry& geometry)
{
  const std::string space = header.Value({ "space" });
  const std::vector<double> signs = SignsToLps(LowerCase(space));
  const std::vector<double> directions = Directions(header);
  const std::string originText = header.Value({ "space origin" });
  const auto origin = ParseNumbers(originText.empty() ? "0 0 0" : originText);
  if (signs.empty() || !AreMillimeters(header.Value({ "space units" })))
  {
    return "its space (" + space + ") is not RAS, LAS or LPS in mm";
  }
  if (directions.size() != 9 || !origin || origin->size() != 3)
  {
    return "its space directions, spacings or space origin cannot be read";
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    geometry.Origin[i] = signs[i] * (*origin)[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      geometry.Steps[axis][i] = signs[i] * directions[3 * axis + i];
    }
  }
  return GeometryProblem(geometry);
}

/// 3D Slicer describes each segment of a segmentation by pairs such as "Segment0_ID:=...".
bool IsSegmentation(const HeaderText& header)
{
  return header.PairKeys.count("segment0_id") > 0;
}

/// What of the format is not read here, in words; empty if all is.
std::string Unsupported(const HeaderText& header)
{
  const std::string dimension = header.Value({ "dimension" });
  const std::string encoding = LowerCase(header.Value({ "encoding" }));
  const std::string dataFile = header.Value({ "data file", "datafile" });
  if (dimension == "4" && IsSegmentation(header))
  {
    return "it is a segmentation of 3D Slicer in several layers, because segments overlap: export "
           "each segment from 3D Slicer as a surface or as a binary label map of its own";
  }
  if (dimension != "3")
  {
    return "it has dimension " + dimension +
      ", only volumes of three with one value a voxel are read";
  }
  if (encoding != "raw" && encoding != "gzip" && encoding != "gz")
  {
    return "its encoding is '" + encoding + "'; save it as raw or gzip";
  }
  const bool isList = LowerCase(dataFile).compare(0, 4, "list") == 0;
  if (isList || dataFile.find('%') != std::string::npos ||
    !header.Value({ "line skip", "lineskip" }).empty())
  {
    return "its voxels lie in several files or behind lines to skip; save it as one .nrrd";
  }
  return std::string();
}

void ReadStorage(const HeaderText& header, const std::string& path, VoxelLayout& layout)
{
  const std::string dataFile = header.Value({ "data file", "datafile" });
  const auto skip = ParseWholeNumbers(header.Value({ "byte skip", "byteskip" }));
  const std::int64_t bytesBefore = skip && skip->size() == 1 ? skip->front() : 0;
  layout.DataFile = dataFile.empty() ? path : BesideHeader(path, dataFile);
  layout.BytesBefore = dataFile.empty() ? header.End : bytesBefore;
  layout.IsCompressed = LowerCase(header.Value({ "encoding" })) != "raw";
  layout.IsBigEndian = LowerCase(header.Value({ "endian" })) == "big";
}
}

VoxelLayout ReadNrrdHeader(const std::string& path)
{
  const HeaderText header = ReadHeaderText(path, { "NRRD", ':', "" });
  VoxelLayout layout;
  layout.Problem = header.Problem.empty() ? Unsupported(header) : header.Problem;
  if (!layout.Problem.empty())
  {
    return layout;
  }
  const auto size = ParseWholeNumbers(header.Value({ "sizes" }));
  layout.ScalarType = ScalarType(LowerCase(header.Value({ "type" })));
  if (layout.ScalarType == VTK_VOID || !size || size->size() != 3)
  {
    return RejectedLayout("its type or sizes cannot be read");
  }
  std::copy(size->begin(), size->end(), layout.Size.begin());
  layout.IsSegmentation = IsSegmentation(header);
  ReadStorage(header, path, layout);
  layout.Problem = ReadGeometry(header, layout.Geometry);
  return layout;
}
}
