// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Page.h
 * @brief One self-contained HTML page about one decimated bone.
 */
#ifndef BoneDecimate_Applications_Page_h
#define BoneDecimate_Applications_Page_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct PageSubject
{
  std::string Name; ///< What the page calls the bone (a file name, never patient data).
  vtkPolyData* Result =
    nullptr; ///< Output port 0 of vtkBoneDecimate: arrays and report in its field data.
  vtkPolyData* Before =
    nullptr; ///< Output port 1, with the distance of each input point; may be null.
  std::string DistanceArrayName; ///< On Before, mm.
  std::vector<std::string>
    Changes;               ///< Of the voxels before extraction; empty: none were requested.
  std::string PictureFile; ///< A PNG to embed; empty: no picture, and the page says so.
};

/// The page as HTML text.
std::string ComposePage(const PageSubject& subject);
}

#endif
