// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Summary.h
 * @brief A few lines on what happened to a bone.
 */
#ifndef BoneDecimate_Applications_Summary_h
#define BoneDecimate_Applications_Summary_h

#include "JsonReport.h"

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// The map of a network that was extracted, and how many voxels of the file changed.
std::string ModelGridText(const ModelGridRecord& model);

/// Triangles, components, and what is proved.
void PrintShortSummary(vtkPolyData* result);

/**
 * @param result Output port 0 of vtkBoneDecimate.
 * @param written The files, in the order in which they are named.
 */
void PrintSummary(
  vtkPolyData* result, const ReportSubject& subject, const std::vector<std::string>& written);
}

#endif
