// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageFiles.h
 * @brief The formats that ITK reads, each with the checks that its library leaves out.
 *
 * All may end the process on damaged files: to be called by ReadIsolated.
 */
#ifndef BoneDecimate_Applications_ImageFiles_h
#define BoneDecimate_Applications_ImageFiles_h

#include "Volume.h"

#include <string>

namespace bonedecimate::volume
{
Volume ReadMetaImage(const std::string& path);

/// Positions are those of ITK: of the sform or the qform, RAS turned into LPS.
Volume ReadNifti(const std::string& path);

/// RAS and LAS are turned into LPS; a file that names no anatomical space is taken as it is. Also segmentations of 3D Slicer (.seg.nrrd).
Volume ReadNrrd(const std::string& path);

/// Of several pages. @param spacing mm.
Volume ReadTiff(const std::string& path, const Vector3& spacing);

/// The TIFF files of a folder, a slice each, in the order of the numbers in their names.
Volume ReadTiffSlices(const std::string& folder, const Vector3& spacing);
}

#endif
