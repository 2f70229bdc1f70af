// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"

#include "DicomFolder.h"
#include "HeaderText.h"
#include "IsolatedReader.h"
#include "MetaImageHeader.h"
#include "NrrdHeader.h"
#include "Options/Text.h"
#include "OutwardContour.h"
#include "RawVoxels.h"
#include "VoxelValues.h"
#include "VtiVolume.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
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
    return RejectedVolume("it does not exist");
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

std::string NumberText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

/// "1, 2, 3 and 17 more"
std::string ListText(const std::vector<int>& labels)
{
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(labels.size(), most); ++i)
  {
    text += (i > 0 ? ", " : "") + std::to_string(labels[i]);
  }
  return labels.size() > most ? text + " and " + std::to_string(labels.size() - most) + " more"
                              : text;
}

/// Of a label map the reason why it has no one surface; of a mask a note.
void CheckLabels(const Volume& volume, LabelPolicy policy, BoneSurface& bone)
{
  const ValueSurvey survey = SurveyValues(volume);
  if (survey.Kind == ValueKind::Mask)
  {
    bone.Note += (bone.Note.empty() ? "" : "; ") + std::string("its values are 0 and ") +
      std::to_string(survey.Labels[0]) +
      " alone: a mask, whose surface has steps as large as its voxels";
  }
  if (survey.Kind == ValueKind::Labels && policy == LabelPolicy::Reject)
  {
    bone.Problem = "it is a label map with the labels " + ListText(survey.Labels) +
      ", whose numbers are names and no intensities: one surface at a value would fuse the parts "
      "and shift their surfaces; export each label as a surface or as a binary label map of its "
      "own, for example from 3D Slicer, or give --intensities on if these are measured values";
  }
}

/// Why the voxels have no surface at that value, or an empty text.
std::string ValuesProblem(vtkImageData* image, double hounsfield)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType strange = CountNotFinite(values);
  if (strange > 0)
  {
    return std::to_string(strange) + " of its voxels are not finite numbers";
  }
  double range[2];
  values->GetRange(range);
  const std::string text = " of its voxels is above " + NumberText(hounsfield) +
    " HU: the values go from " + NumberText(range[0]) + " to " + NumberText(range[1]);
  if (range[1] < hounsfield)
  {
    return "none" + text;
  }
  return range[0] >= hounsfield ? "every one" + text : std::string();
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

BoneSurface ExtractBoneSurface(const std::string& path, double hounsfield, LabelPolicy policy)
{
  BoneSurface bone;
  if (!std::isfinite(hounsfield))
  {
    bone.Problem = "the Hounsfield value is not a finite number";
    return bone;
  }
  const Volume volume = ReadVolume(path);
  bone.Note = volume.Note;
  bone.Problem = volume.Problem.empty() ? ValuesProblem(volume.Image, hounsfield) : volume.Problem;
  if (bone.Problem.empty())
  {
    CheckLabels(volume, policy, bone);
  }
  if (bone.Problem.empty())
  {
    bone.Surface = OutwardContour(volume, hounsfield);
    const double* const spacing = volume.Image->GetSpacing();
    bone.VoxelSize = std::min({ spacing[0], spacing[1], spacing[2] });
  }
  return bone;
}
}
