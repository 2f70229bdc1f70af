// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TiledTiff.h
 * @brief TIFF pages that ITK does not read right: those in tiles, which it makes colors of, and
 * whole numbers of 32 bits, which it leaves at zero (5.2).
 */
#ifndef BoneDecimate_Applications_TiledTiff_h
#define BoneDecimate_Applications_TiledTiff_h

#include "ItkImage.h"

#include <cstdint>
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

  /// Header of one page; all pages must have the same one.
  const ItkHeader& GetHeader() const { return this->Header; }

  /// Reads the next page. @return False if it is truncated or damaged.
  bool ReadVoxels(void* values);

private:
  std::string ReadHeader(const std::string& path);
  bool ReadRows(void* values);
  bool ReadTiles(void* values);

  tiff* File;
  ItkHeader Header;
  std::int64_t PagesRead = 0;
};
}

#endif
