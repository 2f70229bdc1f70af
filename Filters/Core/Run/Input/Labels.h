// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Labels.h
 * @brief Labels of triangles (bone, fragment or segment), and the area of each label before and
 * after.
 */
#ifndef BoneDecimate_Core_Run_Input_Labels_h
#define BoneDecimate_Core_Run_Input_Labels_h

#include "Figures/InputFigures.h"
#include "Geometry/Surface.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct CleanSurface;
class HalfEdgeMesh;

struct Labels
{
  std::vector<Index> OfTriangle;  ///< For each input triangle an index into Names.
  std::vector<std::string> Names; ///< Without dots, because they become parts of paths.
};

/// The label of each triangle of the cleaned surface.
std::vector<Index> LabelsOf(const CleanSurface& clean, const Labels& labels);

/// Labels of the remaining faces, which never change.  @param mesh Built from the surface and
/// simplified.
std::vector<LabelArea> LabelAreas(
  const CleanSurface& clean, const HalfEdgeMesh& mesh, const Labels& labels);
}

#endif
