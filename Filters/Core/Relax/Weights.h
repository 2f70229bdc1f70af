// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Weights.h
 * @brief How the two directions of distance are weighed against each other.
 */
#ifndef BoneDecimate_Core_Relax_Weights_h
#define BoneDecimate_Core_Relax_Weights_h

#include "Knobs.h"
namespace bonedecimate
{
/// Weight of the way from the current surface to the original: 0 lets spikes grow, 1 is too stiff.
static const double BackWeight = Knob("BW",0.1);
/// Of a face's area, how much its middle and each of its corners stand for.
static const double MiddleShare = Knob("BM",0.5);
static const double CornerShare = (1-Knob("BM",.5)) / 3.0;
}

#endif
