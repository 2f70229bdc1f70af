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
}

#endif
