// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CielabColor.h
 * @brief Colors of DICOM as red, green and blue.
 */
#ifndef BoneDecimate_Applications_CielabColor_h
#define BoneDecimate_Applications_CielabColor_h

#include <array>
#include <cstdint>

namespace bonedecimate::volume
{
/**
 * sRGB of a DICOM color. The white point is D65, as in DCMTK, 3D Slicer, OHIF and Weasis; that of
 * PS3.3 C.10.7.1.1 would be D50.
 * @param lab L* from 0 to 100, a* and b* from -128 to 127, each as a number from 0 to 65535.
 * @return Red, green and blue from 0 to 1. Colors that sRGB does not have are clamped.
 */
std::array<double, 3> ColorOfCielab(const std::array<std::uint16_t, 3>& lab);
}

#endif
