// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapseInput.h
 * @brief The data of an edge that a cost of BucketSweep reads. To add a member, fill it in
 * Decimate/Kernels/EdgeEvaluator.cxx.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_CollapseInput_h
#define BoneDecimate_Core_Decimate_Cost_CollapseInput_h

#include "Decimate/Placement/EdgeQuadric.h"

namespace bonedecimate
{
struct CollapseInput
{
  const EdgeQuadric& Quadric;
  Float3 Position;        ///< Relative to the middle of the edge, units.
  float AccumulatedError; ///< The larger error of both ends, units.
  float Normalization;    ///< CostNormalization().
};
}

#endif
