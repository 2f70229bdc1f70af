// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include "Base/Text.h"
#include "BoneVolume.h"
#include "DicomFolder.h"
#include "FilePath.h"
#include "LabelMaps/LabelFields.h"
#include "LabelMaps/MaskFolder.h"
#include "Readers/ImageFiles.h"
#include "Readers/TiffFolder.h"
#include "Readers/VtiVolume.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>

namespace bonedecimate
{
using namespace volume;

namespace
{
namespace fs = std::filesystem;

enum class VolumeKind
{
  None,
  Vti,
  MetaImage,
  Nrrd,
  Nifti,
  Tiff,
  TiffFolder,
  MaskFolder,
  DicomFile,
  DicomFolder
};

struct ExtensionOfKind
{
  const char* Extension;
  VolumeKind Kind;
};

constexpr ExtensionOfKind Extensions[] = {
  { "nii", VolumeKind::Nifti },
  { "nii.gz", VolumeKind::Nifti },
  { "vti", VolumeKind::Vti },
  { "mha", VolumeKind::MetaImage },
  { "mhd", VolumeKind::MetaImage },
  { "nrrd", VolumeKind::Nrrd },
  { "nhdr", VolumeKind::Nrrd },
  { "tif", VolumeKind::Tiff },
  { "tiff", VolumeKind::Tiff },
  { "dcm", VolumeKind::DicomFile },
};

VolumeKind KindByExtension(const fs::path& name)
{
  const std::string last = LowerCase(name.extension().string());
  const std::string extension =
    last == ".gz" ? LowerCase(name.stem().extension().string()) + last : last;
  const auto* found = std::find_if(std::begin(Extensions), std::end(Extensions),
    [&extension](const ExtensionOfKind& one)
    { return extension == std::string(".") + one.Extension; });
  return found == std::end(Extensions) ? VolumeKind::None : found->Kind;
}

/// The folders that TakeSeriesBelow() was called for.
std::set<std::string>& FoldersOfSeries()
{
  static std::set<std::string> folders;
  return folders;
}

std::string& SeriesChoiceText()
{
  static std::string choice;
  return choice;
}

/// The table of contents of a CD, which represents its folder.
bool IsDirectoryFile(const std::string& path)
{
  return LowerCase(FilePath(path).filename().string()) == "dicomdir" && IsDicomFile(path);
}

VolumeKind KindOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(FilePath(path), error))
  {
    return HoldsDicom(path) || FoldersOfSeries().count(path) > 0 ? VolumeKind::DicomFolder
      : HoldsTiffSlices(path)                                    ? VolumeKind::TiffFolder
      : HoldsMasks(path)                                         ? VolumeKind::MaskFolder
                                                                 : VolumeKind::None;
  }
  if (IsDirectoryFile(path))
  {
    return VolumeKind::DicomFolder;
  }
  const VolumeKind kind = KindByExtension(FilePath(path));
  // A TIFF of one page is a picture.
  const bool isPicture =
    kind == VolumeKind::Tiff && fs::is_regular_file(FilePath(path), error) && IsTiffPicture(path);
  return isPicture ? VolumeKind::None : kind;
}

/// Whether nothing says how far its voxels are apart.
bool LacksSpacing(const std::string& path, VolumeKind kind)
{
  std::error_code error;
  if (kind == VolumeKind::Tiff || kind == VolumeKind::TiffFolder)
  {
    return true;
  }
  if (!fs::is_regular_file(FilePath(path), error))
  {
    return false;
  }
  return (kind == VolumeKind::Vti && !VtiHasSpacing(path)) ||
    (kind == VolumeKind::MetaImage && !MetaImageHasSpacing(path)) ||
    (kind == VolumeKind::Nrrd && !NrrdHasSpacing(path));
}

/// Sets the spacing of a volume whose own steps mean nothing.
LayeredVolume WithSpacing(LayeredVolume volume, const VoxelSpacing& spacing)
{
  std::array<Vector3, 3>& steps = volume.Header.Geometry.Steps;
  for (std::size_t axis = 0; spacing && axis < 3; ++axis)
  {
    const double length = Length(steps[axis]);
    steps[axis] = Scaled(steps[axis], (*spacing)[axis] / length);
  }
  return volume;
}

/// Why it is rejected without a look into it; empty if it is not.
std::string Unreadable(const std::string& path, VolumeKind kind, const VoxelSpacing& spacing)
{
  std::error_code error;
  if (!fs::exists(FilePath(path), error))
  {
    return "there is no such file";
  }
  const bool isFolder = fs::is_directory(FilePath(path), error);
  if (!isFolder && (fs::file_size(FilePath(path), error) == 0 || error))
  {
    return "it is empty or cannot be read";
  }
  if (kind == VolumeKind::None)
  {
    return "it is no volume; read are " + ReadVolumesText();
  }
  if (!spacing && LacksSpacing(path, kind))
  {
    const bool isTiff = kind == VolumeKind::Tiff || kind == VolumeKind::TiffFolder;
    return std::string(isTiff ? "TIFF has no distance between slices"
                              : "its header does not say how far its voxels are apart") +
      ": give --spacing X,Y,Z in mm";
  }
  return std::string();
}
}

bool IsVolume(const std::string& path)
{
  return KindOf(path) != VolumeKind::None;
}

bool IsVolumeFile(const std::string& path)
{
  return KindByExtension(FilePath(path)) != VolumeKind::None;
}

std::string ReadVolumesText()
{
  return ".nii, .nii.gz, .nrrd, .nhdr, .seg.nrrd, .mha, .mhd, .vti, a .tif of several pages, a "
         ".dcm of segments or of several frames, a DICOMDIR, and a folder of DICOM files or TIFF "
         "slices or with a mask for each structure";
}

bool TakeSeriesBelow(const std::string& folder)
{
  const bool hasSeries = KindOf(folder) == VolumeKind::None && !DicomFilesBelow(folder, 1).empty();
  if (hasSeries)
  {
    FoldersOfSeries().insert(folder);
  }
  return hasSeries;
}

void ChooseSeries(const std::string& choice)
{
  SeriesChoiceText() = choice;
}

bool HasSeries(const std::string& path)
{
  return KindOf(path) == VolumeKind::DicomFolder;
}

std::vector<std::string> VolumeExtensions()
{
  std::vector<std::string> extensions;
  for (const ExtensionOfKind& one : Extensions)
  {
    extensions.emplace_back(one.Extension);
  }
  return extensions;
}

bool NeedsSpacing(const std::string& path)
{
  return LacksSpacing(path, KindOf(path));
}

namespace volume
{
const std::string& RequestedSeries()
{
  return SeriesChoiceText();
}

std::unique_ptr<IsolatedReader> OpenVolume(
  const std::string& path, const VoxelSpacing& spacing, const SegmentSelection& selection)
{
  const VolumeKind kind = KindOf(path);
  const std::string problem = Unreadable(path, kind, spacing);
  if (!problem.empty())
  {
    return std::make_unique<IsolatedReader>(problem);
  }
  const VoxelSpacing missing = LacksSpacing(path, kind) ? spacing : VoxelSpacing();
  return std::make_unique<IsolatedReader>(
    [&]
    {
      switch (kind)
      {
        case VolumeKind::Vti:
          return WithSpacing(LayersOf(ReadVti(path)), missing);
        case VolumeKind::MetaImage:
          return WithSpacing(OpenMetaImage(path), missing);
        case VolumeKind::Nrrd:
          return WithSpacing(OpenNrrd(path, selection), missing);
        case VolumeKind::Nifti:
          return OpenNifti(path);
        case VolumeKind::Tiff:
          return OpenTiff(path, *spacing);
        case VolumeKind::TiffFolder:
          return OpenTiffSlices(path, *spacing);
        case VolumeKind::MaskFolder:
          return LayersOf(ReadMasks(path, selection));
        case VolumeKind::DicomFile:
          return OpenDicomFile(path, selection);
        default:
          return OpenDicomFolder(
            IsDirectoryFile(path) ? FilePath(path).parent_path().string() : path, selection);
      }
    });
}

Volume ReadVolume(
  const std::string& path, const VoxelSpacing& spacing, const SegmentSelection& selection)
{
  const std::unique_ptr<IsolatedReader> reader = OpenVolume(path, spacing, selection);
  const VolumeHeader& header = reader->GetHeader();
  Volume volume;
  volume.Geometry = header.Geometry;
  volume.Layers = header.Layers;
  volume.Note = header.Note;
  volume.Remark = header.Remark;
  volume.Problem = header.Problem;
  if (volume.Problem.empty())
  {
    volume.Image = AllocateImage(header.Size, header.ScalarType);
    CopyLabelFields(header.Fields, volume.Image->GetFieldData());
    volume.Problem = reader->ReadLayers(header.Size[2], volume.Image->GetScalarPointer());
  }
  return volume.Problem.empty() ? volume : RejectedVolume(volume.Problem);
}
}
}
