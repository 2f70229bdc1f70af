// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageFiles.h
 * @brief The formats that ITK reads, each with the checks that its library leaves out.
 *
 * Voxels that lie in the file one after the other as numbers of their type, packed by gzip or not,
 * are read layer by layer (StoredVoxels.h), slices in files of their own one by one, all others
 * whole by ITK.
 *
 * All may end the process on damaged files: to be called by an IsolatedReader.
 */
#ifndef BoneDecimate_Applications_ImageFiles_h
#define BoneDecimate_Applications_ImageFiles_h

#include "LabelMaps/SegmentSelection.h"
#include "Layers/LayeredVolume.h"

#include <string>

namespace bonedecimate::volume
{
LayeredVolume OpenMetaImage(const std::string& path);

/// Whether the header says how far voxels are apart. Reads no more than its text.
bool MetaImageHasSpacing(const std::string& path);
bool NrrdHasSpacing(const std::string& path);

/// Positions are those of ITK: of the sform or the qform, RAS turned into LPS.
LayeredVolume OpenNifti(const std::string& path);

/// RAS and LAS are turned into LPS; a file that names no anatomical space is taken as it is. Also
/// segmentations of 3D Slicer (.seg.nrrd).
LayeredVolume OpenNrrd(const std::string& path, const SegmentSelection& selection);

/// Opens a file with several pages. @param spacing mm.
LayeredVolume OpenTiff(const std::string& path, const Vector3& spacing);

/// The TIFF files of a folder, a slice each, in the order of the numbers in their names.
LayeredVolume OpenTiffSlices(const std::string& folder, const Vector3& spacing);
}

#endif
