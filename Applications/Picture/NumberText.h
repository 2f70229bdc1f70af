// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NumberText.h
 * @brief Numbers as people read them: 666,264 and 0.125 mm.
 */
#ifndef BoneDecimate_Applications_NumberText_h
#define BoneDecimate_Applications_NumberText_h

#include <initializer_list>
#include <string>

namespace bonedecimate
{
/// Rounded to that many decimals, thousands set apart by commas.
std::string GroupedText(double value, int decimals = 0);

/// A length to the micrometer, without its unit; a smaller one that is not zero is "< 0.001".
std::string MillimeterText(double millimeters);

/// A measured distance, mm, rounded down: printed beside its proved bound, which is rounded up, it
/// never looks larger. One below 0.0001 that is not zero is "< 0.0001".
std::string MeasuredText(double millimeters);

/// A proved upper bound of a distance, mm, with as many decimals, rounded up.
std::string BoundText(double millimeters);

/// An area or a volume with a decimal, smaller ones with three significant digits.
std::string SizeText(double value);

/// Few digits, for ticks and labels: "0.25", "10".
std::string ShortText(double value);

/// The least step times a power of ten that is not below a positive value. @param steps Ascending,
/// 1 to 10.
double RoundUp(double value, std::initializer_list<double> steps);
}

#endif
