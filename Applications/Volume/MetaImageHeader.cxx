// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MetaImageHeader.h"

#include "HeaderText.h"
#include "Options/Text.h"

#include <algorithm>
#include <map>

namespace bonedecimate::volume
{
namespace
{
const std::map<std::string, int> ScalarTypes{ { "met_char", VTK_SIGNED_CHAR },
  { "met_uchar", VTK_UNSIGNED_CHAR }, { "met_short", VTK_SHORT },
  { "met_ushort", VTK_UNSIGNED_SHORT }, { "met_int", VTK_INT }, { "met_uint", VTK_UNSIGNED_INT },
  { "met_long", VTK_INT }, { "met_ulong", VTK_UNSIGNED_INT }, { "met_long_long", VTK_LONG_LONG },
  { "met_ulong_long", VTK_UNSIGNED_LONG_LONG }, { "met_float", VTK_FLOAT },
  { "met_double", VTK_DOUBLE } };

bool IsTrue(const std::string& value)
{
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

/// The numbers of a field, or those given if the field is missing; empty if they are not so many
/// numbers.
std::vector<double> Numbers(const std::string& value, const std::vector<double>& otherwise)
{
  const std::vector<double> numbers =
    value.empty() ? otherwise : ParseNumbers(value).value_or(std::vector<double>());
  return numbers.size() == otherwise.size() ? numbers : std::vector<double>();
}

std::string ReadGeometry(const HeaderText& header, VolumeGeometry& geometry)
{
  const auto spacing =
    Numbers(header.Value({ "elementspacing", "elementsize" }), { 1.0, 1.0, 1.0 });
  const auto origin = Numbers(header.Value({ "offset", "position", "origin" }), { 0.0, 0.0, 0.0 });
  const auto directions = Numbers(header.Value({ "transformmatrix", "rotation", "orientation" }),
    { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 });
  if (spacing.empty() || origin.empty() || directions.empty())
  {
    return "its ElementSpacing, Offset or TransformMatrix cannot be read";
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    geometry.Origin[axis] = origin[axis];
    for (std::size_t i = 0; i < 3; ++i)
    {
      geometry.Steps[axis][i] = spacing[axis] * directions[3 * axis + i];
    }
  }
  return GeometryProblem(geometry);
}

/// What of the format is not read here, in words; empty if all is.
std::string Unsupported(const HeaderText& header)
{
  const std::string dimensions = header.Value({ "ndims" });
  const std::string channels = header.Value({ "elementnumberofchannels" });
  if (dimensions != "3")
  {
    return "it has NDims = " + dimensions + ", only volumes of three are read";
  }
  if (!channels.empty() && channels != "1")
  {
    return "it has " + channels + " values a voxel, a CT has one";
  }
  if (header.Fields.count("binarydata") > 0 && !IsTrue(header.Value({ "binarydata" })))
  {
    return "its voxels are text; save it with BinaryData = True";
  }
  const std::string dataFile = header.Value({ "elementdatafile" });
  if (LowerCase(dataFile).compare(0, 4, "list") == 0 || dataFile.find('%') != std::string::npos)
  {
    return "its voxels lie in several files; save it as one .mha";
  }
  return std::string();
}

/// Where the voxels begin and how they are stored.
void ReadStorage(const HeaderText& header, const std::string& path, VoxelLayout& layout)
{
  const std::string dataFile = header.Value({ "elementdatafile" });
  const bool isLocal = LowerCase(dataFile) == "local";
  const auto skip = ParseWholeNumbers(header.Value({ "headersize" }));
  const std::int64_t bytesBefore = skip && skip->size() == 1 ? skip->front() : 0;
  layout.DataFile = isLocal ? path : BesideHeader(path, dataFile);
  layout.BytesBefore = isLocal ? header.End : bytesBefore;
  layout.IsCompressed = IsTrue(header.Value({ "compresseddata" }));
  layout.IsBigEndian = IsTrue(header.Value({ "elementbyteordermsb", "binarydatabyteordermsb" }));
}
}

VoxelLayout ReadMetaImageHeader(const std::string& path)
{
  const HeaderText header = ReadHeaderText(path, { "", '=', "elementdatafile" });
  VoxelLayout layout;
  layout.Problem = header.Problem.empty() ? Unsupported(header) : header.Problem;
  if (!layout.Problem.empty())
  {
    return layout;
  }
  const auto type = ScalarTypes.find(LowerCase(header.Value({ "elementtype" })));
  const auto size = ParseWholeNumbers(header.Value({ "dimsize" }));
  if (type == ScalarTypes.end() || !size || size->size() != 3)
  {
    return RejectedLayout("its ElementType or DimSize cannot be read");
  }
  layout.ScalarType = type->second;
  std::copy(size->begin(), size->end(), layout.Size.begin());
  ReadStorage(header, path, layout);
  layout.Problem = ReadGeometry(header, layout.Geometry);
  return layout;
}
}
