// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FracturedLeg.h
 * @brief What a CT of the broken leg would measure at a point.
 *
 * An oblique jagged fracture of the shaft, the lower part displaced, a butterfly fragment broken
 * out on the inner side and three loose chips. The fibula is whole.
 */
#ifndef BoneDecimate_Data_FracturedLeg_h
#define BoneDecimate_Data_FracturedLeg_h

#include "Shapes.h"

namespace phantom
{
/// HU with the blur of the scanner, without its noise.
double LegValue(const Point& p);

/// What a segmentation of the leg with the fracture reduced would say: 1 and 2 are the tibia above
/// and below the fracture, which touch there; 3 is the fibula, and 0 everything else.
int LegLabel(const Point& p);
}

#endif
