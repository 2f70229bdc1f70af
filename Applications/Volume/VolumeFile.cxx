// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include "BoneVolume.h"
#include "DicomFolder.h"
#include "HeaderText.h"
#include "IsolatedReader.h"
#include "MetaImageHeader.h"
#include "NrrdHeader.h"
#include "Options/Text.h"
#include "RawVoxels.h"
#include "VtiVolume.h"

#include <filesystem>
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
  DicomFolder
};

VolumeKind KindByExtension(const fs::path& name)
{
  const std::string extension = LowerCase(name.extension().string());
  const std::string before = LowerCase(name.stem().extension().string());
  if (extension == ".nii" || (extension == ".gz" && before == ".nii"))
  {
    return VolumeKind::Nifti;
  }
  if (extension == ".vti")
  {
    return VolumeKind::Vti;
  }
  if (extension == ".mha" || extension == ".mhd")
  {
    return VolumeKind::MetaImage;
  }
  return extension == ".nrrd" || extension == ".nhdr" ? VolumeKind::Nrrd : VolumeKind::None;
}

VolumeKind KindOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    return HoldsDicom(path) ? VolumeKind::DicomFolder : VolumeKind::None;
  }
  return KindByExtension(path);
}

Volume ReadLayout(const VoxelLayout& layout)
{
  return layout.Problem.empty() ? ReadVoxels(layout) : RejectedVolume(layout.Problem);
}
}

bool IsVolume(const std::string& path)
{
  return KindOf(path) != VolumeKind::None;
}

bool IsVolumeFile(const std::string& path)
{
  return KindByExtension(path) != VolumeKind::None;
}

namespace volume
{
Volume ReadVolume(const std::string& path)
{
  const VolumeKind kind = KindOf(path);
  if (kind == VolumeKind::DicomFolder)
  {
    return ReadIsolated(ReadDicomFolder, path);
  }
  std::error_code error;
  if (!fs::exists(path, error))
  {
    return RejectedVolume("there is no such file");
  }
  if (kind == VolumeKind::None)
  {
    return RejectedVolume(
      "it is no volume: .vti, .mha, .mhd, .nrrd, .nhdr or a folder of DICOM files");
  }
  if (kind == VolumeKind::Nifti)
  {
    return RejectedVolume("NIfTI is not read yet: save it as .nrrd or .mha, for example with 3D "
                          "Slicer or ITK-SNAP");
  }
  if (fs::file_size(path, error) == 0 || error)
  {
    return RejectedVolume("it is empty or cannot be read");
  }
  if (kind == VolumeKind::Vti)
  {
    return ReadIsolated(ReadVti, path);
  }
  return ReadLayout(
    kind == VolumeKind::MetaImage ? ReadMetaImageHeader(path) : ReadNrrdHeader(path));
}
}
}
