// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleBounds.h
 * @brief How far each triangle alone is from the other surface at most: the search of Search.h, one triangle at a time.
 */
#ifndef BoneDecimate_Core_Certificate_TriangleBounds_h
#define BoneDecimate_Core_Certificate_TriangleBounds_h

#include "Search.h"

#include <vector>

namespace bonedecimate::certificate
{
/**
 * @param goal Its gaps are those of each triangle to the largest distance of one of its points.
 * @param most mm, an upper bound of all that is known already; what the monitor stopped keeps it.
 * @return mm, of each simplex.
 */
std::vector<double> FindTriangleBounds(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, double most, const Monitor& monitor);
}

#endif
