// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpacingRuns.h
 * @brief Whether the distances of slices change on purpose: a head is often scanned finely below
 * and coarsely above.
 */
#ifndef BoneDecimate_Applications_SpacingRuns_h
#define BoneDecimate_Applications_SpacingRuns_h

#include <cstddef>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// Distances that are equal one after the other.
struct SpacingRun
{
  std::size_t First = 0; ///< Slice.
  std::size_t Count = 0;
  double Distance = 0.0; ///< Mean, mm.
};

/// Whether a distance differs from the usual one by more than positions are rounded.
bool IsOtherDistance(double distance, double usual);

std::vector<SpacingRun> RunsOf(const std::vector<double>& distances);

/// A slice that is missing is a distance by itself.
bool AreOnPurpose(const std::vector<SpacingRun>& runs);

/// "4 mm", with four digits.
std::string LengthText(double millimeters);
}

#endif
