// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TiffFolder.h
 * @brief Which TIFF files and folders are volumes, without decoding anything.
 */
#ifndef BoneDecimate_Applications_TiffFolder_h
#define BoneDecimate_Applications_TiffFolder_h

#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// By the extensions .tif and .tiff.
bool IsNamedLikeTiff(const std::string& path);

/// Whether a file is TIFF and has one page.
bool IsTiffPicture(const std::string& path);

/// Whether the chain of its pages comes back to one of them; readers follow it without end.
bool HasCircularPages(const std::string& path);

/// Whether most files of a folder, and at least two, are TIFF files of one page.
bool HoldsTiffSlices(const std::string& folder);

struct TiffSlices
{
  std::vector<std::string> Files; ///< By the numbers in their names.
  std::string Problem;            ///< Why the folder is rejected; empty if it is not.
};

/// The numbers are what differs between the names of files. One that is missing is a reason to
/// reject.
TiffSlices FindTiffSlices(const std::string& folder);
}

#endif
