// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles.h"

#include "DataFile.h"
#include "ItkImage.h"
#include "TiffFolder.h"

#include <cstdarg>
#include <cstdint>
#include <filesystem>
#include <tiffio.h>

namespace bonedecimate::volume
{
namespace
{
/// Notes errors of libtiff, after which ITK may go on with fewer pages or rows.
class TiffErrors
{
public:
  TiffErrors()
  {
    HasError = false;
    TIFFSetWarningHandler(nullptr);
    TIFFSetErrorHandler(&TiffErrors::Note);
  }

  static bool HasError;

private:
  static void Note(const char*, const char*, va_list) { HasError = true; }
};

bool TiffErrors::HasError = false;

/// ITK reads all pages with the size of the first one, and makes colors of tiles.
std::string PagesProblem(const std::string& path)
{
  TIFF* const file = TIFFOpen(path.c_str(), "r");
  if (!file)
  {
    return "it is not a TIFF file";
  }
  std::array<std::uint32_t, 2> first{};
  bool isEven = true;
  bool isTiled = false;
  int page = 0;
  do
  {
    std::array<std::uint32_t, 2> size{};
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &size[0]);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &size[1]);
    first = page++ == 0 ? size : first;
    isEven = isEven && size == first;
    isTiled = isTiled || TIFFIsTiled(file) != 0;
  } while (TIFFReadDirectory(file));
  TIFFClose(file);
  if (TiffErrors::HasError)
  {
    return "it is truncated or damaged";
  }
  if (isTiled)
  {
    return "its pages are stored in tiles; save it in strips";
  }
  return isEven ? std::string() : "its pages are not all of one size";
}

VolumeGeometry GeometryOf(const Vector3& spacing)
{
  VolumeGeometry geometry;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    geometry.Steps[axis][axis] = spacing[axis];
  }
  return geometry;
}

/// Reads the voxels of a slice. Returns what went wrong, or an empty text.
std::string ReadSlice(const std::string& path, const ItkHeader& first, void* values)
{
  const std::string pages = PagesProblem(path);
  ItkImage slice(ItkImage::Format::Tiff, path, 2);
  const ItkHeader& header = slice.GetHeader();
  const std::string problem = pages.empty() ? header.Problem : pages;
  if (!problem.empty())
  {
    return problem;
  }
  if (header.Size != first.Size || header.ScalarType != first.ScalarType ||
    header.Components != first.Components)
  {
    return "its size or type of voxels is not that of the first slice";
  }
  return slice.ReadVoxels(values) && !TiffErrors::HasError ? std::string() : DamagedVoxels;
}
}

LayeredVolume OpenTiff(const std::string& path, const Vector3& spacing)
{
  const TiffErrors errors;
  const std::string pages = PagesProblem(path);
  ItkImage image(ItkImage::Format::Tiff, path);
  const ItkHeader& header = image.GetHeader();
  const std::string problem = FirstOf({ pages, header.Problem, ComponentsProblem(header) });
  const std::string size =
    problem.empty() ? SizeProblem(header.Size, 1, SizeOfFile(path), true) : problem;
  if (!size.empty())
  {
    return RejectedLayers(size);
  }
  Volume volume = image.ReadVolume();
  volume.Geometry = GeometryOf(spacing);
  return TiffErrors::HasError ? RejectedLayers(DamagedVoxels) : LayersOf(volume);
}

LayeredVolume OpenTiffSlices(const std::string& folder, const Vector3& spacing)
{
  const TiffErrors errors;
  const TiffSlices slices = FindTiffSlices(folder);
  if (!slices.Problem.empty())
  {
    return RejectedLayers(slices.Problem);
  }
  const ItkHeader first = ItkImage(ItkImage::Format::Tiff, slices.Files.front(), 2).GetHeader();
  std::array<std::int64_t, 3> size = first.Size;
  size[2] = static_cast<std::int64_t>(slices.Files.size());
  std::uint64_t bytes = 0;
  for (const std::string& file : slices.Files)
  {
    bytes += SizeOfFile(file);
  }
  const std::string problem = FirstOf({ first.Problem, ComponentsProblem(first) });
  const std::string sizeProblem = problem.empty() ? SizeProblem(size, 1, bytes, true) : problem;
  if (!sizeProblem.empty())
  {
    return RejectedLayers(sizeProblem);
  }
  LayeredVolume volume;
  volume.Header.Geometry = GeometryOf(spacing);
  volume.Header.Size = size;
  volume.Header.ScalarType = first.ScalarType;
  volume.ReadLayer = [files = slices.Files, first, next = std::size_t(0)](void* values) mutable
  {
    const std::string& file = files[next++];
    const std::string damage = ReadSlice(file, first, values);
    return damage.empty() ? damage
                          : std::filesystem::path(file).filename().string() + ": " + damage;
  };
  return volume;
}
}
