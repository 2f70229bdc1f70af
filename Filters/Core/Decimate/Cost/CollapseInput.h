// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapseInput.h
 * @brief What a cost of BucketSweep may read of an edge. A cost that needs more adds a member here
 * and fills it in Decimate/Kernels/EdgeEvaluator.cxx.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_CollapseInput_h
#define BoneDecimate_Core_Decimate_Cost_CollapseInput_h

#include "Decimate/Placement/EdgeQuadric.h"

namespace bonedecimate
{
struct CollapseInput
{
  const EdgeQuadric& Quadric;
  Float3 Position;        ///< From the middle of the edge, units.
  float AccumulatedError; ///< The error of either end, the larger, units.
  float Normalization;    ///< CostNormalization().
};
}

#endif
