// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleBounds.h
 * @brief An upper bound of the distance of each triangle to the other surface, by the search of
 * Search.h for one triangle.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_TriangleBounds_h
#define BoneDecimate_Core_Proof_Certificate_TriangleBounds_h

#include "PieceSearch.h"

#include <vector>

namespace bonedecimate::certificate
{
/**
 * @param goal Its gaps apply to each triangle.
 * @param max Receives the largest distance found.
 * @return mm, for each triangle; after an abort the remaining ones are infinite.
 */
std::vector<double> FindTriangleBounds(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, MaxExcess& max, const Monitor& monitor);
}

#endif
