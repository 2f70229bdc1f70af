// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Labels.h
 * @brief Which bone, fragment or segment each triangle belongs to, and what area each of them has before and after.
 */
#ifndef BoneDecimate_Core_Labels_h
#define BoneDecimate_Core_Labels_h

#include "Report.h"
#include "Surface.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct CleanSurface;
class HalfEdgeMesh;

struct Labels
{
  std::vector<Index> OfTriangle;  ///< Of each input triangle: a place in Names.
  std::vector<std::string> Names; ///< Without dots: they become parts of paths.
};

/// Of each triangle of the cleaned surface.
std::vector<Index> LabelsOf(const CleanSurface& clean, const Labels& labels);

/// Faces keep their labels: nothing joins two of different ones.  @param mesh Made of the surface and simplified.
std::vector<LabelArea> LabelAreas(
  const CleanSurface& clean, const HalfEdgeMesh& mesh, const Labels& labels);

/// The largest change of an area, as a share of what it was; 0 without labels.
double LargestLabelChange(const Report& report);
}

#endif
