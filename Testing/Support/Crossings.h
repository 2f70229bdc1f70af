// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Crossings.h
 * @brief Which triangles of a surface intersect, and how near two surfaces come, by trying all
 * pairs in long double.
 */
#ifndef BoneDecimate_Testing_Crossings_h
#define BoneDecimate_Testing_Crossings_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <functional>

namespace bonedecimate::testsupport
{
/// Pairs of triangles that have more in common than common corners or a common edge.
std::int64_t CountCrossings(const Surface& surface);
bool Cross(const Surface& surface, const Triangle& a, const Triangle& b);

/// mm, the least distance between triangles chosen by the first and by the second; 0 where they
/// cross.
using IsChosen = std::function<bool(const Triangle&)>;
double LeastDistance(const Surface& surface, const IsChosen& first, const IsChosen& second);

/// mm, the least distance between two components.
double LeastDistanceOfComponents(const Surface& surface);
}

#endif
