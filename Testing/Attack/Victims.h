// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Victims.h
 * @brief Random input surfaces of the attack: shapes or pieces of large surfaces, with noise and
 * removed triangles.
 */
#ifndef BoneDecimate_Testing_Victims_h
#define BoneDecimate_Testing_Victims_h

#include "Geometry/Surface.h"
#include "Random.h"

#include <vector>

namespace bonedecimate::testsupport
{
/// mm
double MeanEdge(const Surface& surface);

/// mm, for a quarter of the runs a length near that of the edges; for others 0.
double DrawEdgeLength(Random& random, const Surface& surface);

/// mm, a tolerance of each point: 0 in one ball, none in another; in between it grows with the
/// distance.
/// @param error mm, half of the largest tolerance.
std::vector<double> AnyMap(Random& random, const Surface& surface, double error);

/**
 * About ten to two thousand triangles, at random scale and position.
 * @param large Surfaces from which half of the results are cut; may be empty.
 */
Surface AnyVictim(Random& random, const std::vector<Surface>& large);
}

#endif
