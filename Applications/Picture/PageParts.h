// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PageParts.h
 * @brief The pieces an HTML page is put together from; none of them knows the report.
 */
#ifndef BoneDecimate_Applications_PageParts_h
#define BoneDecimate_Applications_PageParts_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// First the heads of the columns, then the rows; the first cell of each row is its head. Cells are
/// HTML.
std::string Table(const std::vector<std::vector<std::string>>& rows);

/// The bytes of a file; empty if it cannot be read.
std::string Base64Of(const std::string& file);

/// The fraction of the distances (mm, ascending, at least one) that lie within x mm, as a curve: inline SVG.
std::string DistanceCurve(const std::vector<double>& sorted);
}

#endif
