// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilePath.h"
#include "ImageFiles.h"

#include "DataFile.h"
#include "ItkImage.h"
#include "TiffFolder.h"
#include "TiledTiff.h"

#include <cstdarg>
#include <cstdint>
#include <memory>
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

struct TiffPages
{
  std::int64_t Count = 0;
  bool AreForLibtiff = false; ///< ITK does not read them right (TiledTiff.h).
  std::string Problem;        ///< Why they are no volume; empty if they are.
};

/// Width, height, bits and format of values, and whether it is stored in tiles.
using PageShape = std::array<std::uint32_t, 5>;

PageShape ShapeOfPage(TIFF* file)
{
  std::array<std::uint32_t, 2> size{};
  std::array<std::uint16_t, 2> type{};
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &size[0]);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &size[1]);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &type[0]);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &type[1]);
  return { { size[0], size[1], type[0], type[1], TIFFIsTiled(file) != 0 ? 1U : 0U } };
}

/// ITK reads all pages as if they were like the first one.
TiffPages PagesOf(const std::string& path)
{
  TiffPages pages;
  if (HasCircularPages(path))
  {
    pages.Problem = "its pages form a circle: one of them has an earlier page as the next one";
    return pages;
  }
  TIFF* const file = TIFFOpen(path.c_str(), "r");
  if (!file)
  {
    pages.Problem = "it is not a TIFF file";
    return pages;
  }
  const PageShape first = ShapeOfPage(file);
  bool isEven = true;
  do
  {
    isEven = isEven && ShapeOfPage(file) == first;
    ++pages.Count;
  } while (TIFFReadDirectory(file));
  TIFFClose(file);
  const bool isLarge = first[2] > 32 || (first[2] == 32 && first[3] != SAMPLEFORMAT_IEEEFP);
  pages.AreForLibtiff = first.back() != 0 || isLarge;
  pages.Problem = TiffErrors::HasError ? "it is truncated or damaged"
    : isEven                           ? ""
                                       : "its pages are not all of one size and type";
  return pages;
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

/// Reads the header of a file with one page.
ItkHeader SliceHeader(const std::string& path)
{
  const TiffPages pages = PagesOf(path);
  if (!pages.Problem.empty())
  {
    ItkHeader rejected;
    rejected.Problem = pages.Problem;
    return rejected;
  }
  ItkHeader header = pages.AreForLibtiff ? TiledTiff(path).GetHeader()
                                         : ItkImage(ItkImage::Format::Tiff, path, 2).GetHeader();
  header.Problem = FirstOf({ header.Problem, ComponentsProblem(header) });
  return header;
}

template <typename Image>
std::string ReadSliceOf(Image&& slice, const ItkHeader& first, void* values)
{
  const ItkHeader& header = slice.GetHeader();
  if (!header.Problem.empty())
  {
    return header.Problem;
  }
  if (header.Size != first.Size || header.ScalarType != first.ScalarType ||
    header.Components != first.Components)
  {
    return "its size or type of voxels is not that of the first slice";
  }
  return slice.ReadVoxels(values) && !TiffErrors::HasError ? std::string() : DamagedVoxels;
}

/// Reads the voxels of a slice. Returns what went wrong, or an empty text.
std::string ReadSlice(const std::string& path, const ItkHeader& first, void* values)
{
  const TiffPages pages = PagesOf(path);
  return !pages.Problem.empty() ? pages.Problem
    : pages.AreForLibtiff       ? ReadSliceOf(TiledTiff(path), first, values)
                          : ReadSliceOf(ItkImage(ItkImage::Format::Tiff, path, 2), first, values);
}

/// All pages, one after the other.
LayeredVolume OpenByLibtiff(const std::string& path, std::int64_t pages, const Vector3& spacing)
{
  const auto file = std::make_shared<TiledTiff>(path);
  const ItkHeader& header = file->GetHeader();
  LayeredVolume volume;
  volume.Header.Size = { { header.Size[0], header.Size[1], pages } };
  volume.Header.ScalarType = header.ScalarType;
  volume.Header.Geometry = GeometryOf(spacing);
  const std::string problem =
    FirstOf({ header.Problem, SizeProblem(volume.Header.Size, 1, SizeOfFile(path), true) });
  if (!problem.empty())
  {
    return RejectedLayers(problem);
  }
  volume.ReadLayer = [file](void* values)
  { return file->ReadVoxels(values) && !TiffErrors::HasError ? std::string() : DamagedVoxels; };
  return volume;
}
}

LayeredVolume OpenTiff(const std::string& path, const Vector3& spacing)
{
  const TiffErrors errors;
  const TiffPages pages = PagesOf(path);
  if (!pages.Problem.empty())
  {
    return RejectedLayers(pages.Problem);
  }
  if (pages.AreForLibtiff)
  {
    return OpenByLibtiff(path, pages.Count, spacing);
  }
  ItkImage image(ItkImage::Format::Tiff, path);
  const ItkHeader& header = image.GetHeader();
  const std::string problem = FirstOf({ header.Problem, ComponentsProblem(header) });
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
  const ItkHeader first = SliceHeader(slices.Files.front());
  std::array<std::int64_t, 3> size = first.Size;
  size[2] = static_cast<std::int64_t>(slices.Files.size());
  std::uint64_t bytes = 0;
  for (const std::string& file : slices.Files)
  {
    bytes += SizeOfFile(file);
  }
  const std::string sizeProblem =
    first.Problem.empty() ? SizeProblem(size, 1, bytes, true) : first.Problem;
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
    return damage.empty() ? damage : FilePath(file).filename().string() + ": " + damage;
  };
  return volume;
}
}
