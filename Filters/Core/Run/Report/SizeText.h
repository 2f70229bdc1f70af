// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SizeText.h
 * @brief What is said about the size of an input, and a largest error compared with it.
 */
#ifndef BoneDecimate_Core_Run_Report_SizeText_h
#define BoneDecimate_Core_Run_Report_SizeText_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// A sentence for the status of CheckSize() of InputSize.h.
std::string SizeMessage(const SizeFigures& size, InputStatus status);

/// Warnings: the size is odd, or a smaller error than the requested one was used.
std::vector<std::string> SizeWarnings(const SizeFigures& size);

/// A warning for two surfaces of which one is nine or more times as large as the other: bones of
/// one unit hardly are; mm, cm, inches and m are. Empty for others.
/// @param before,after Diagonals of the reference and the result, mm.
std::string UnitsWarning(double before, double after);
}

#endif
