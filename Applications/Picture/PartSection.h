// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartSection.h
 * @brief The section of a page about area, volume and thickness of components or labels.
 */
#ifndef BoneDecimate_Applications_PartSection_h
#define BoneDecimate_Applications_PartSection_h

#include "ReportFields.h"

#include <string>

namespace bonedecimate
{
/// The section as HTML; empty if parts were not compared.
std::string PartSection(const ReportFields& report);

/// "label 2", or "component at 1.0, 2.0, 3.0 mm".
/// @param part Its position in the list of the report.
std::string PartName(const ReportFields& report, int part);

/// "before ARROW after"; empty if the figure is not known.
/// @param figure "area", "volume", "thickness_median", ...
std::string PartChange(
  const ReportFields& report, int part, const std::string& figure, const std::string& arrow);
}

#endif
