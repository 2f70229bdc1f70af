// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceColors.h
 * @brief The colors of distances: near as bone, far as dark violet.
 */
#ifndef BoneDecimate_Applications_DistanceColors_h
#define BoneDecimate_Applications_DistanceColors_h

#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace bonedecimate
{
/// Where the colors end, mm: a readable number not below 99.9 % of the distances (ascending).
double ColorRange(const std::vector<double>& sorted);

/// Colors of distances from 0 to range, mm.
vtkSmartPointer<vtkColorTransferFunction> DistanceColors(double range);
}

#endif
