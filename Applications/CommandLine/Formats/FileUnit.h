// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileUnit.h
 * @brief The unit of the coordinates that a reader returned, for formats whose files differ in it.
 */
#ifndef BoneDecimate_Applications_FileUnit_h
#define BoneDecimate_Applications_FileUnit_h

#include "vtkPolyData.h"

#include <string>

namespace bonedecimate
{
/// Notes the unit with the surface. @param unit A name of LengthUnit.h.
void SetFileUnit(const std::string& unit, vtkPolyData* surface);

/// Takes the note off; empty if there was none.
std::string TakeFileUnit(vtkPolyData* surface);
}

#endif
