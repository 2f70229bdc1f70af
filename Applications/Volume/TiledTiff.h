// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TiledTiff.h
 * @brief TIFF pages that are stored in tiles, which ITK makes colors of.
 */
#ifndef BoneDecimate_Applications_TiledTiff_h
#define BoneDecimate_Applications_TiledTiff_h

#include "ItkImage.h"

#include <string>

struct tiff;

namespace bonedecimate::volume
{
/// Reads by libtiff. May end the process on damaged files: to be used in an IsolatedReader.
class TiledTiff
{
public:
  explicit TiledTiff(const std::string& path);
  ~TiledTiff();
  TiledTiff(const TiledTiff&) = delete;
  TiledTiff& operator=(const TiledTiff&) = delete;

  /// Of one page: all have to be alike.
  const ItkHeader& GetHeader() const { return this->Header; }

  /// Reads the next page. @return False if it is truncated or damaged.
  bool ReadVoxels(void* values);

private:
  std::string ReadHeader(const std::string& path);

  tiff* File;
  ItkHeader Header;
  std::int64_t PagesRead = 0;
};
}

#endif
