// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelsPageFile.h
 * @brief The page of the levels of a run, with its picture.
 */
#ifndef BoneDecimate_Applications_LevelsPageFile_h
#define BoneDecimate_Applications_LevelsPageFile_h

#include "Files/StagedFile.h"

#include "vtkBoneDecimateLevels.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Writes the page of all marked levels.
 * @param filter After an update; selects other levels.
 * @param name What the page calls the surface.
 * @param warnings Gets a sentence if the picture could not be drawn.
 */
void WriteLevelsPage(vtkBoneDecimateLevels* filter, const std::string& name, StagedFile& page,
  std::vector<std::string>& warnings);
}

#endif
