// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HeaderUnit.h
 * @brief The unit of length of a header, and geometries in other units than the millimeter.
 */
#ifndef BoneDecimate_Applications_HeaderUnit_h
#define BoneDecimate_Applications_HeaderUnit_h

#include "Volume.h"

#include <string>

namespace bonedecimate::volume
{
struct HeaderUnit
{
  std::string Name;         ///< Name in words; empty: the header names no unit.
  double Millimeters = 1.0; ///< Length of one unit; 0: the unit is no known unit of length.
};

/// @param text "um", "mm", "centimeter" and the like; empty or "?" is the millimeter.
HeaderUnit UnitOf(const std::string& text);

/// Why a unit is rejected; empty if it is not.
std::string UnitProblem(const HeaderUnit& unit);

/// Tells the user that lengths were converted; empty if they were not.
std::string UnitNote(const HeaderUnit& unit);

/// The geometry, converted from the unit to mm.
VolumeGeometry InMillimeters(const VolumeGeometry& geometry, const HeaderUnit& unit);
}

#endif
