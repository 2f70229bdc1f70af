// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ItkImage.h
 * @brief An image file by a reader of ITK. Its source is the only one that includes ITK.
 */
#ifndef BoneDecimate_Applications_ItkImage_h
#define BoneDecimate_Applications_ItkImage_h

#include "Volume.h"

#include <cstdint>
#include <memory>
#include <string>

namespace bonedecimate::volume
{
/// What a header announces.
struct ItkHeader
{
  std::array<std::int64_t, 3> Size{ { 1, 1, 1 } };
  int ScalarType = VTK_VOID; ///< Type of the voxels in memory.
  int Components = 1;        ///< Values a voxel.
  bool HasLayers = false;    ///< The components are a list.
  bool IsText = false;       ///< The voxels are decimal numbers.
  bool HasGeometry = true;   ///< False: ITK accepts no axes but perpendicular ones of this format.
  VolumeGeometry Geometry;   ///< Position and steps, if the file holds a volume.
  std::string Problem;       ///< Why the file is rejected; empty if it is not.
};

/// May end the process on damaged files, writes to the terminal: to be used in an IsolatedReader.
class ItkImage
{
public:
  enum class Format
  {
    MetaImage,
    Nifti,
    Nrrd,
    Tiff
  };

  /// Reads the header. @param dimensions 3, or 2 for a slice.
  ItkImage(Format format, const std::string& path, int dimensions = 3);
  ~ItkImage();
  ItkImage(const ItkImage&) = delete;
  ItkImage& operator=(const ItkImage&) = delete;

  const ItkHeader& GetHeader() const { return this->Header; }

  /// Text of a key of the header; empty if there is no such key.
  std::string GetText(const std::string& key) const;

  /// @return False if the voxels are truncated or damaged.
  bool ReadVoxels(void* values);

  /// Allocates and reads.
  Volume ReadVolume();

private:
  struct Internals;

  std::string ReadSize(int dimensions);
  std::string ReadGeometry();

  std::unique_ptr<Internals> Internal;
  ItkHeader Header;
};
}

#endif
