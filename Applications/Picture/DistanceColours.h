// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceColours.h
 * @brief The colours of distances: near as bone, far as dark violet.
 */
#ifndef BoneDecimate_Applications_DistanceColours_h
#define BoneDecimate_Applications_DistanceColours_h

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace bonedecimate
{
/// The values of an array in ascending order, those that are not finite left out.
std::vector<double> SortedDistances(vtkDataArray* distances);

/// The least value that is not below that fraction of them; 0 if there are none.
double Quantile(const std::vector<double>& sorted, double fraction);

/// Where the colours end, mm: a readable number not below 99.9 % of the distances.
double ColourRange(const std::vector<double>& sorted);

/// From 0 to range (mm).
vtkSmartPointer<vtkColorTransferFunction> DistanceColours(double range);
}

#endif
