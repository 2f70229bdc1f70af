// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundText.h
 * @brief Proved bounds as text, rounded outwards, so that what is printed is proved, too.
 */
#ifndef BoneDecimate_Core_Figures_BoundText_h
#define BoneDecimate_Core_Figures_BoundText_h

#include <string>

namespace bonedecimate
{
/// Where bounds as small as the rounding of a file are printed.
inline constexpr int DecimalsOfRounding = 9;

/// With that many decimals.
std::string FixedText(double number, int decimals);

/// The largest such number that is not above the bound, and the least that is not below.
std::string LowerBoundText(double bound, int decimals);
std::string UpperBoundText(double bound, int decimals);
}

#endif
