// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NumberRange.h
 * @brief The range of a numeric option, and the sentence for a value outside of it.
 */
#ifndef BoneDecimate_Core_Options_NumberRange_h
#define BoneDecimate_Core_Options_NumberRange_h

#include <string>

namespace bonedecimate
{
/// Largest absolute value of a length, area or volume; points farther from the origin are rejected,
/// too.
constexpr double MaxNumber = 1e30;

struct NumberRange
{
  double Minimum; ///< Both ends are allowed.
  double Maximum;
  bool IsWhole = false;
  std::string Unit = {}; ///< "mm", "triangles", ...; empty where there is none.
};

/// "0 to 1e30"
std::string EndsText(const NumberRange& range);

/// "a number from 0 to 1e30 mm"
std::string RangeText(const NumberRange& range);

/// Whether the value is in the range and, if required, whole. NaN and infinity never are.
bool IsInRange(const NumberRange& range, double value);

/// "MaximumError takes a number from 0 to 1e30 mm, not -1"; empty if the value is in the range.
std::string CheckNumber(const std::string& name, const NumberRange& range, double value);

/// Shortest decimals that read back the same; "NaN", "infinity", "-infinity".
std::string NumberText(double value);

/// The same as people write it, "1e30" for "1e+30".
std::string SentenceNumber(double value);
}

#endif
