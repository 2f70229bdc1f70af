// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PageParts.h
 * @brief The pieces HTML pages are put together from; none of them knows the report.
 */
#ifndef BoneDecimate_Applications_PageParts_h
#define BoneDecimate_Applications_PageParts_h

#include "ReportFields.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bonedecimate
{
/// First the heads of the columns, then the rows; the first cell of each row is its head. Cells are
/// HTML.
std::string Table(const std::vector<std::vector<std::string>>& rows);

/// The coordinates below a path, mm: "1.00, 2.00, 3.00".
std::string PositionText(const ReportFields& report, const std::string& path);

/// One of the figures that a page begins with. @param hasLoss Whether it tells of something lost.
std::string FigureTile(const std::string& figure, const std::string& words, bool hasLoss = false);

std::string Base64(const std::string& bytes);

/// The bytes of a file in base64; empty if it cannot be read.
std::string Base64Of(const std::string& file);

/// A PNG in the page, or the sentence that there is none.
/// @param surfaces What it shows, in words.
std::string EmbeddedPicture(
  const std::string& file, const std::string& surfaces = "The bone before and after");

/// The date of a page: from SOURCE_DATE_EPOCH, which makes outputs reproducible, or the clock.
std::string DateText();

/// What a page of 20 MB leaves to the interactive view.
std::size_t BytesOfViewer(std::size_t bytesOfPicture);

/// The fraction of the distances (mm, ascending, at least one) that lie within x mm, as a curve:
/// inline SVG.
std::string DistanceCurve(const std::vector<double>& sorted);
}

#endif
