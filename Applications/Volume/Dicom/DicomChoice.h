// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomChoice.h
 * @brief Which series of a folder is taken: the one that the user names, or the largest.
 */
#ifndef BoneDecimate_Applications_DicomChoice_h
#define BoneDecimate_Applications_DicomChoice_h

#include "DicomSeries.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// A series as a user may name it. Descriptions are shown where a choice is impossible, and written
/// to no report.
struct SeriesEntry
{
  std::string Identifier;  ///< Unique.
  std::string Description; ///< In UTF-8.
  std::string Text;        ///< "24 slices of 512 x 512 in S1/S20".
};

struct SeriesChoice
{
  std::size_t Index = 0; ///< Index of the entry that is taken.
  bool IsRequested = false;
  std::string Problem; ///< Why nothing is taken, with the list; empty if something is.
};

/**
 * The entry of a choice that was made: a number from 1, a unique identifier, or a description,
 * whole or in part, in any case. Of several entries with the same identifier the first counts.
 */
SeriesChoice ChooseFrom(const std::vector<SeriesEntry>& entries, const std::string& choice);

/// Groups of slices, the largest first, then segmentations. A folder of segmentations alone needs a
/// choice if there are several.
/// @param choice Empty: none was made.
SeriesChoice ChooseSeriesOf(const std::vector<DicomSlices>& groups,
  const std::vector<SeriesEntry>& segmentations, const std::string& folder,
  const std::string& choice);
}

#endif
