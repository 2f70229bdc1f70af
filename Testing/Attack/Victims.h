// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Victims.h
 * @brief Random surfaces on which promises are tried to be broken: shapes, or pieces cut out of large surfaces, shaken and torn.
 */
#ifndef BoneDecimate_Testing_Victims_h
#define BoneDecimate_Testing_Victims_h

#include "Random.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate::testsupport
{
/// mm
double MeanEdge(const Surface& surface);

/**
 * Some ten to two thousand triangles, at any scale and anywhere.
 * @param large Surfaces to cut pieces from, half of the time; may be empty.
 */
Surface AnyVictim(Random& random, const std::vector<Surface>& large);
}

#endif
