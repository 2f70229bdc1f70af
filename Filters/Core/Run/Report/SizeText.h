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
#include "Geometry/Surface.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// A sentence for the status of CheckSize() of InputSize.h.
std::string SizeMessage(const SizeFigures& size, InputStatus status);

/// Warnings: the size is odd, or a smaller error than the requested one was used.
std::vector<std::string> SizeWarnings(const SizeFigures& size);

/// Warnings of surfaces that are compared: a tolerance of more than a quarter of the reference, or
/// a reference that is not the size of a bone; a surface nine or more times as large as the other,
/// which bones of one unit hardly are, but mm, cm, inches and m are.
/// @param tolerance The largest, mm; 0 or less: none.
std::vector<std::string> PairSizeWarnings(
  const Surface& reference, const Surface& result, double tolerance);
}

#endif
