// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Headline.h
 * @brief The first lines of a page: how far the surfaces are apart, how much smaller the result is,
 * and whether anything is missing.
 */
#ifndef BoneDecimate_Applications_HeadlineSection_h
#define BoneDecimate_Applications_HeadlineSection_h

#include "ReportFields.h"
#include "SurfaceExtents.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// The labels of the surfaces of a run; both empty without labels.
struct PageLabels
{
  std::vector<LabelExtent> Before;
  std::vector<LabelExtent> After;
};

/// @param before May be null.
PageLabels PageLabelsOf(vtkPolyData* before, vtkPolyData* result);

/// @param sorted Distances of the points of the original, mm, ascending; may be empty.
std::string HeadlineSection(const ReportFields& report, const std::vector<double>& sorted,
  const PageLabels& labels, const SpeckFigures& specks);

/// The option that leaves out the specks; empty unless there are many.
std::string SpeckHint(const SpeckFigures& specks);

/// A table of the labels, before and after; empty without labels.
std::string LabelSection(const PageLabels& labels);
}

#endif
