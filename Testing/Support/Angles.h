// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Angles.h
 * @brief Sine and cosine with the same bits on every platform. Those of math libraries differ in
 * the last bit.
 */
#ifndef BoneDecimate_Testing_Angles_h
#define BoneDecimate_Testing_Angles_h

namespace bonedecimate::testsupport
{
/// Radians, up to a few turns; the nearest double but for one in about 2^40 angles.
double Cosine(double angle);
double Sine(double angle);
}

#endif
