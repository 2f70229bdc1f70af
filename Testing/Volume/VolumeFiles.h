// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeFiles.h
 * @brief Writes scans in the formats of the tests, implemented from the format specifications and
 * independent of the readers.
 */
#ifndef BoneDecimate_Testing_VolumeFiles_h
#define BoneDecimate_Testing_VolumeFiles_h

#include "Specimen.h"

#include <array>
#include <cstddef>
#include <string>

namespace bonedecimate::testing
{
std::string ReadBytes(const std::string& path);
void WriteBytes(const std::string& path, const std::string& bytes);

/// The voxels as they lie in memory on a little-endian system, or the other way about.
std::string VoxelBytes(const Scan& scan, bool isBigEndian = false);

std::string Deflated(const std::string& bytes);
std::string Gzipped(const std::string& bytes);

/// Header of a .mha or .mhd; the last line, ElementDataFile, is left to the caller.
std::string MetaHeader(const Scan& scan, const std::string& moreLines = "");

/// Uncompressed, in one file.
void WriteMeta(const std::string& path, const Scan& scan);

/// With these voxels, as they are packed.
void WriteCompressedMeta(const std::string& path, const Scan& scan, const std::string& packed);

/// Header of a .nrrd in the given space (LPS, RAS or LAS); the empty line is left to the caller.
std::string NrrdHeader(const Scan& scan, const std::string& space, const std::string& encoding);

void WriteNrrd(const std::string& path, const Scan& scan);

/// Header of a .nii with an sform, in RAS as the format has it.
std::string NiftiHeader(const Scan& scan);

/// Header and voxels in one file; gzipped if its name ends so.
void WriteNifti(const std::string& path, const Scan& scan);

/// Pages of a TIFF file, or one of them.
std::string TiffBytes(const Scan& scan, std::size_t firstPage, std::size_t pages);

/// A .seg.nrrd of 3D Slicer with one byte a voxel. @param layers Values a voxel: an axis of its own
/// if there are several.
/// @param segments Lines of the header such as "Segment0_Name:=Femur".
std::string SegmentationBytes(const std::array<std::size_t, 3>& size, std::size_t layers,
  const std::string& segments, const std::string& voxels);

void WriteVti(const std::string& path, const Scan& scan);
}

#endif
