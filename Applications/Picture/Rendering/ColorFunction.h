// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ColorFunction.h
 * @brief The colors of distances as VTK's mappers and color bars take them.
 */
#ifndef BoneDecimate_Applications_ColorFunction_h
#define BoneDecimate_Applications_ColorFunction_h

#include "DistanceColors.h"

#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

namespace bonedecimate
{
/// Colors of distances from 0 to the end of the scale.
vtkSmartPointer<vtkColorTransferFunction> MakeColorFunction(const ColorScale& scale);
}

#endif
