// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoneVolume.h
 * @brief A CT volume in, the bone surface at a Hounsfield value out, where the patient lay.
 */
#ifndef BoneDecimate_Applications_BoneVolume_h
#define BoneDecimate_Applications_BoneVolume_h

#include "VoxelSpacing.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// True for .vti, .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz files, for TIFF files of several pages
/// and for folders that hold DICOM files, TIFF slices or masks (MaskFolder.h); and for one DICOM
/// file (.dcm), which is rejected.
bool IsVolume(const std::string& path);

/// Whether the extension is that of a volume; the file need not exist.
bool IsVolumeFile(const std::string& path);

/// The extensions of these files, in lower case, without the first dot: "nii.gz".
std::vector<std::string> VolumeExtensions();

/// The files and folders that are read as volumes, in words.
std::string ReadVolumesText();

/**
 * From now on a folder whose subfolders have DICOM files is one volume, if it is none already: the
 * largest series in it and below.
 * @return Whether there are any.
 */
bool TakeSeriesBelow(const std::string& folder);

/**
 * From now on folders of several DICOM series give the one that the text names: its number in the
 * list, its unique identifier, or its description, whole or in part. An impossible choice is
 * rejected with the list.
 * @param choice Empty: the largest.
 */
void ChooseSeries(const std::string& choice);

/// Whether ChooseSeries() counts for it: a folder of DICOM files or a DICOMDIR.
bool HasSeries(const std::string& path);

/// Why a folder without the series that was chosen is rejected. A batch passes over it.
inline constexpr const char* NoSeriesReason = "it has no series ";

struct BoneSurface
{
  /// mm, patient coordinates of the file (LPS); null if rejected.
  vtkSmartPointer<vtkPolyData> Surface;
  double VoxelSize = 0.0;   ///< mm, the least side of its voxels.
  std::int64_t Padding = 0; ///< Voxels above the value that were not measured and are no bone.
  std::string Problem;      ///< Why it was rejected; empty if it was not.
  std::string Note;         ///< What of the input was left aside, for the user; may be empty.
  std::string Remark;       ///< What was done as the user wants it; may be empty.
};

/// How the values of a volume are taken that look like the labels of a segmentation.
enum class LabelPolicy
{
  Reject,       ///< One surface would fuse the labels and lie at another position for each of them.
  AsIntensities ///< As those of any other volume.
};

/// What is done with the values of a volume before its surface is extracted. @param grid Without
/// voxels: where they are, as SetLabelGrid() says it.
using VoxelChange = std::function<void(vtkImageData* image, vtkImageData* grid)>;

/**
 * The surface at the given Hounsfield value by flying edges over the whole volume, normals
 * outwards, transformed by the volume's origin, spacing and direction. Nothing of the header but
 * its geometry and its values reaches the surface.
 */
BoneSurface ExtractBoneSurface(const std::string& path, double hounsfield,
  LabelPolicy policy = LabelPolicy::Reject, const VoxelSpacing& spacing = {},
  const VoxelChange& change = {});
}

#endif
