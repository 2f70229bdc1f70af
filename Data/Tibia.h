// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tibia.h
 * @brief The upper half of a left shin bone before it broke, and the fibula beside it.
 *
 * LPS: x to the left, y to the back, z to the head, mm. The joint lies at z = 0, the shaft below.
 */
#ifndef BoneDecimate_Data_Tibia_h
#define BoneDecimate_Data_Tibia_h

#include "Shapes.h"

namespace phantom
{
/// Distance to the outside of the bone.
double Tibia(const Point& p);
double Fibula(const Point& p);

/// HU inside the tibia: compact bone so many mm below the outside, then trabeculae near the joint,
/// marrow below.
double TibiaValue(const Point& p, double depth);
double FibulaValue(double depth);
}

#endif
