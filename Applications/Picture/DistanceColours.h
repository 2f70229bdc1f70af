// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceColours.h
 * @brief The colours of distances: near as bone, far as dark violet.
 */
#ifndef BoneDecimate_Applications_DistanceColours_h
#define BoneDecimate_Applications_DistanceColours_h

#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace bonedecimate
{
/// Where the colours end, mm: a readable number not below 99.9 % of the distances (ascending).
double ColourRange(const std::vector<double>& sorted);

/// From 0 to range (mm).
vtkSmartPointer<vtkColorTransferFunction> DistanceColours(double range);
}

#endif
