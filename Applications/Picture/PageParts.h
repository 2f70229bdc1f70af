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
/// Text from outside as HTML text or attribute.
std::string Escape(const std::string& text);

/// First the heads of the columns, then the rows; the first cell of each row is its head. Cells are
/// HTML.
std::string Table(const std::vector<std::vector<std::string>>& rows);

/// An <img> with the file inside it; empty if the file cannot be read.
std::string EmbeddedPng(const std::string& file, const std::string& alternative);

/// The share of the distances (mm, ascending, at least one) that lie within x mm, as a curve:
/// inline SVG.
std::string ShareCurve(const std::vector<double>& sorted);

/// Colours for light and dark screens, A4 on paper, one column on a phone.
std::string StyleSheet();
}

#endif
