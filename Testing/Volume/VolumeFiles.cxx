// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <zlib.h>

namespace bonedecimate::testing
{
using volume::Length;

namespace
{
/// By zlib; 15 bits of window make a zlib stream, 16 more a gzip file.
std::string Packed(const std::string& bytes, int windowBits)
{
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  std::string source = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(source.data());
  stream.avail_in = static_cast<uInt>(source.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// Puts a number into a header, little-endian.
template <typename Number>
void Put(std::string& header, std::size_t position, Number number)
{
  std::memcpy(header.data() + position, &number, sizeof(number));
}

/// An entry of a directory of TIFF: tag, type, count and value.
std::string TiffEntry(std::uint16_t tag, std::uint32_t value)
{
  std::string entry(12, '\0');
  Put<std::uint16_t>(entry, 0, tag);
  Put<std::uint16_t>(entry, 2, 4); // a 32-bit number
  Put<std::uint32_t>(entry, 4, 1);
  Put<std::uint32_t>(entry, 8, value);
  return entry;
}

std::ostringstream ExactStream()
{
  std::ostringstream text;
  text << std::setprecision(17);
  return text;
}
}

std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string VoxelBytes(const Scan& scan, bool isBigEndian)
{
  std::string bytes;
  for (const short value : scan.Values)
  {
    const char low = static_cast<char>(value & 0xff);
    const char high = static_cast<char>((value >> 8) & 0xff);
    bytes += isBigEndian ? high : low;
    bytes += isBigEndian ? low : high;
  }
  return bytes;
}

std::string Deflated(const std::string& bytes)
{
  return Packed(bytes, 15);
}

std::string Gzipped(const std::string& bytes)
{
  return Packed(bytes, 15 + 16);
}

std::string MetaHeader(const Scan& scan, const std::string& moreLines)
{
  const VolumeGeometry& geometry = scan.Geometry;
  std::ostringstream text = ExactStream();
  text << "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix =";
  for (const Vector3& step : geometry.Steps)
  {
    text << ' ' << step[0] / Length(step) << ' ' << step[1] / Length(step) << ' '
         << step[2] / Length(step);
  }
  text << "\nOffset = " << geometry.Origin[0] << ' ' << geometry.Origin[1] << ' '
       << geometry.Origin[2] << "\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI"
       << "\nElementSpacing = " << Length(geometry.Steps[0]) << ' ' << Length(geometry.Steps[1])
       << ' ' << Length(geometry.Steps[2]) << "\nDimSize = " << scan.Size[0] << ' ' << scan.Size[1]
       << ' ' << scan.Size[2] << "\nElementType = MET_SHORT\n"
       << moreLines;
  return text.str();
}

void WriteMeta(const std::string& path, const Scan& scan)
{
  WriteBytes(path, MetaHeader(scan) + "ElementDataFile = LOCAL\n" + VoxelBytes(scan));
}

void WriteCompressedMeta(const std::string& path, const Scan& scan, const std::string& packed)
{
  const std::string lines =
    "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n";
  WriteBytes(path, MetaHeader(scan, lines) + "ElementDataFile = LOCAL\n" + packed);
}

std::string NrrdHeader(const Scan& scan, const std::string& space, const std::string& encoding)
{
  const double signOfX = space == "right-anterior-superior" ? -1.0 : 1.0;
  const double signOfY = space == "left-posterior-superior" ? 1.0 : -1.0;
  const auto vectorText = [signOfX, signOfY](const Vector3& v)
  {
    std::ostringstream vector = ExactStream();
    vector << '(' << signOfX * v[0] << ',' << signOfY * v[1] << ',' << v[2] << ')';
    return vector.str();
  };
  const auto& steps = scan.Geometry.Steps;
  std::ostringstream text;
  text << "NRRD0004\n# Complete NRRD file format specification at:\ntype: short\ndimension: 3\n"
       << "space: " << space << "\nsizes: " << scan.Size[0] << ' ' << scan.Size[1] << ' '
       << scan.Size[2] << "\nspace directions: " << vectorText(steps[0]) << ' '
       << vectorText(steps[1]) << ' ' << vectorText(steps[2])
       << "\nkinds: domain domain domain\nendian: little\nencoding: " << encoding
       << "\nspace origin: " << vectorText(scan.Geometry.Origin) << '\n';
  return text.str();
}

void WriteNrrd(const std::string& path, const Scan& scan)
{
  WriteBytes(path, NrrdHeader(scan, "left-posterior-superior", "raw") + "\n" + VoxelBytes(scan));
}

std::string NiftiHeader(const Scan& scan)
{
  std::string header(352, '\0');
  Put<std::int32_t>(header, 0, 348);
  Put<std::int16_t>(header, 40, 3);
  Put<std::int16_t>(header, 70, 4); // 16-bit integers
  Put<std::int16_t>(header, 72, 16);
  Put<float>(header, 76, 1.0F);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Put(header, 42 + 2 * axis, static_cast<std::int16_t>(scan.Size[axis]));
    Put(header, 80 + 4 * axis, static_cast<float>(Length(scan.Geometry.Steps[axis])));
    for (std::size_t row = 0; row < 3; ++row)
    {
      const double sign = row < 2 ? -1.0 : 1.0;
      Put(header, 280 + 16 * row + 4 * axis,
        static_cast<float>(sign * scan.Geometry.Steps[axis][row]));
      Put(header, 292 + 16 * row, static_cast<float>(sign * scan.Geometry.Origin[row]));
    }
  }
  for (std::size_t axis = 3; axis < 7; ++axis)
  {
    Put<std::int16_t>(header, 42 + 2 * axis, 1);
  }
  Put<float>(header, 108, 352.0F);   // where the voxels begin
  Put<float>(header, 112, 1.0F);     // slope
  header[123] = 2;                   // mm
  Put<std::int16_t>(header, 254, 1); // the sform is that of the scanner
  header.replace(344, 3, "n+1");
  return header;
}

void WriteNifti(const std::string& path, const Scan& scan)
{
  const std::string bytes = NiftiHeader(scan) + VoxelBytes(scan);
  WriteBytes(path, path.substr(path.size() - 3) == ".gz" ? Gzipped(bytes) : bytes);
}

std::string TiffBytes(const Scan& scan, std::size_t firstPage, std::size_t pages)
{
  const std::string voxels = VoxelBytes(scan);
  const std::size_t pageBytes = 2 * scan.Size[0] * scan.Size[1];
  std::string file = std::string("II*\0\x08\0\0\0", 8);
  for (std::size_t page = 0; page < pages; ++page)
  {
    const auto columns = static_cast<std::uint32_t>(scan.Size[0]);
    const auto rows = static_cast<std::uint32_t>(scan.Size[1]);
    const std::size_t directory = 2 + 10 * 12 + 4;
    const auto strip = static_cast<std::uint32_t>(file.size() + directory);
    std::string next(4, '\0');
    if (page + 1 < pages)
    {
      Put(next, 0, static_cast<std::uint32_t>(file.size() + directory + pageBytes));
    }
    file += std::string("\x0a\0", 2) + TiffEntry(256, columns) + TiffEntry(257, rows) +
      TiffEntry(258, 16) + TiffEntry(259, 1) + TiffEntry(262, 1) + TiffEntry(273, strip) +
      TiffEntry(277, 1) + TiffEntry(278, rows) +
      TiffEntry(279, static_cast<std::uint32_t>(pageBytes)) + TiffEntry(339, 2) + next +
      voxels.substr((firstPage + page) * pageBytes, pageBytes);
  }
  return file;
}

std::string SegmentationBytes(const std::array<std::size_t, 3>& size, std::size_t layers,
  const std::string& segments, const std::string& voxels)
{
  const bool hasLayers = layers > 1;
  std::ostringstream text;
  text << "NRRD0004\ntype: unsigned char\ndimension: " << (hasLayers ? 4 : 3)
       << "\nspace: left-posterior-superior\nsizes: "
       << (hasLayers ? std::to_string(layers) + " " : "") << size[0] << ' ' << size[1] << ' '
       << size[2] << "\nspace directions: " << (hasLayers ? "none " : "")
       << "(1,0,0) (0,1,0) (0,0,1)\nkinds: " << (hasLayers ? "list " : "")
       << "domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n"
       << segments << "\n";
  return text.str() + voxels;
}

void WriteVti(const std::string& path, const Scan& scan)
{
  const VolumeGeometry& geometry = scan.Geometry;
  vtkNew<vtkImageData> image;
  const int shift = 3; // an extent that does not begin at zero
  image->SetExtent(shift, static_cast<int>(scan.Size[0]) - 1 + shift, 0,
    static_cast<int>(scan.Size[1]) - 1, 0, static_cast<int>(scan.Size[2]) - 1);
  image->AllocateScalars(VTK_SHORT, 1);
  std::copy(scan.Values.begin(), scan.Values.end(), static_cast<short*>(image->GetScalarPointer()));
  image->SetSpacing(
    Length(geometry.Steps[0]), Length(geometry.Steps[1]), Length(geometry.Steps[2]));
  Vector3 origin = geometry.Origin;
  double directions[9];
  for (std::size_t i = 0; i < 3; ++i)
  {
    origin[i] -= shift * geometry.Steps[0][i];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      directions[3 * i + axis] = geometry.Steps[axis][i] / Length(geometry.Steps[axis]);
    }
  }
  image->SetOrigin(origin.data());
  image->SetDirectionMatrix(directions);
  vtkNew<vtkStringArray> name;
  name->SetName("PatientName");
  name->InsertNextValue("Secret^Patient");
  image->GetFieldData()->AddArray(name);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}
}
