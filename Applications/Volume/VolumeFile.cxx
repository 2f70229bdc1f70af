// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include "BoneVolume.h"
#include "DicomFolder.h"
#include "FilePath.h"
#include "ImageFiles.h"
#include "LabelFields.h"
#include "Options/Text.h"
#include "TiffFolder.h"
#include "VtiVolume.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
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

VolumeKind KindOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(FilePath(path), error))
  {
    return HoldsDicom(path)   ? VolumeKind::DicomFolder
      : HoldsTiffSlices(path) ? VolumeKind::TiffFolder
                              : VolumeKind::None;
  }
  const VolumeKind kind = KindByExtension(FilePath(path));
  // A TIFF of one page is a picture.
  return kind == VolumeKind::Tiff && IsTiffPicture(path) ? VolumeKind::None : kind;
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
    return "it is no volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz, a .tif of several "
           "pages, a .dcm of segments or a folder of DICOM files or TIFF slices";
  }
  if ((kind == VolumeKind::Tiff || kind == VolumeKind::TiffFolder) && !spacing)
  {
    return "TIFF has no distance between slices: give --spacing X,Y,Z in mm";
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
  const VolumeKind kind = KindOf(path);
  return kind == VolumeKind::Tiff || kind == VolumeKind::TiffFolder;
}

namespace volume
{
std::unique_ptr<IsolatedReader> OpenVolume(const std::string& path, const VoxelSpacing& spacing)
{
  const VolumeKind kind = KindOf(path);
  const std::string problem = Unreadable(path, kind, spacing);
  if (!problem.empty())
  {
    return std::make_unique<IsolatedReader>(problem);
  }
  return std::make_unique<IsolatedReader>(
    [&]
    {
      switch (kind)
      {
        case VolumeKind::Vti:
          return LayersOf(ReadVti(path));
        case VolumeKind::MetaImage:
          return OpenMetaImage(path);
        case VolumeKind::Nrrd:
          return OpenNrrd(path);
        case VolumeKind::Nifti:
          return OpenNifti(path);
        case VolumeKind::Tiff:
          return OpenTiff(path, *spacing);
        case VolumeKind::TiffFolder:
          return OpenTiffSlices(path, *spacing);
        case VolumeKind::DicomFile:
          return OpenDicomFile(path);
        default:
          return OpenDicomFolder(path);
      }
    });
}

Volume ReadVolume(const std::string& path, const VoxelSpacing& spacing)
{
  const std::unique_ptr<IsolatedReader> reader = OpenVolume(path, spacing);
  const VolumeHeader& header = reader->GetHeader();
  Volume volume;
  volume.Geometry = header.Geometry;
  volume.Note = header.Note;
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
