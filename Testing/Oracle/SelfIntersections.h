// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelfIntersections.h
 * @brief Pairs of triangles of one surface that cut or overlap each other, by CGAL.
 */
#ifndef BoneDecimate_Testing_Oracle_SelfIntersections_h
#define BoneDecimate_Testing_Oracle_SelfIntersections_h

#include "TriangleFile.h"

#include <cstdint>

/// What CGAL's Polygon_mesh_processing counts on a manifold surface, for any triangles: a pair
/// counts if it has more in common than its common points. Exact predicates. Triangles without area
/// are left out.
std::int64_t CountSelfIntersections(const Triangles& welded);

#endif
