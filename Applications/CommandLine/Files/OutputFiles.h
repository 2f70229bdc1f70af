// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputFiles.h
 * @brief All files of one bone, reserved before the work and given their names after it.
 */
#ifndef BoneDecimate_Applications_OutputFiles_h
#define BoneDecimate_Applications_OutputFiles_h

#include "Arguments/Arguments.h"
#include "StagedFile.h"
#include "StagedFolder.h"

#include "vtkPolyData.h"

#include <list>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct OutputFiles
{
  /// Reserves every file, so that a folder that takes none is found out before the work.
  explicit OutputFiles(const Arguments& arguments);

  /// Adds a file for the surface of a segment. @throws Failure(ExitCode::Usage) if one of that name
  /// is written already.
  StagedFile& AddSegment(const std::string& target);

  std::optional<StagedFolder> Folder; ///< Folder of the segments; removed after its files.
  /// The output first, unless segments have files of their own, then those of --also.
  std::list<StagedFile> Surfaces;
  std::list<StagedFile> Segments;
  std::optional<StagedFile> Blocks; ///< The .vtm file.
  std::optional<StagedFile> Heatmap;
  /// Also without --picture if a page wants to embed one; see KeepsPicture.
  std::optional<StagedFile> Picture;
  std::optional<StagedFile> Page;
  std::optional<StagedFile> Report;
  bool KeepsPicture = false;

  /// Gives all of them their names; returns the names.
  std::vector<std::string> Commit();
};
}

#endif
