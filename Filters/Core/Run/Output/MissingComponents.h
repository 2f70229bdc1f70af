// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MissingComponents.h
 * @brief Components of a surface that another one lacks, wherever their numbers agree.
 *
 * A corner or the centroid of a triangle of the result counts for the component of the reference
 * that has the triangle nearest to it. A component for which nothing counts is missing. So a
 * component that is lost beside another one is found, even if a third one was split in two.
 */
#ifndef BoneDecimate_Core_Run_Output_MissingComponents_h
#define BoneDecimate_Core_Run_Output_MissingComponents_h

#include "Figures/ComparedFigures.h"
#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// The largest diagonal first. Of a reference with one component nothing is missing.
/// @param shift From the coordinates of the result to those of the reference, mm.
/// @param origin Of the coordinates of the reference, mm.
std::vector<MissingComponent> FindMissing(const Surface& reference, const Surface& result,
  const Vector3& shift, const Vector3& origin, int threads);
}

#endif
