// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileFrame.h
 * @brief The axes of coordinates as 3D Slicer writes them into surface files: "SPACE=RAS" or
 * "SPACE=LPS".
 *
 *     STL      header         OBJ, PLY  comment         VTK  title         VTP  field array "SPACE"
 *
 * A surface in memory has it as the field array "SPACE" of one string, whatever file it comes from.
 * Without it, 3D Slicer takes coordinates for LPS, so that a file in RAS that lost it is turned by
 * half a revolution.
 */
#ifndef BoneDecimate_Applications_FileFrame_h
#define BoneDecimate_Applications_FileFrame_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <string_view>

namespace bonedecimate
{
/// "RAS", "LPS", or empty: the text has no "SPACE=" of them.
std::string FrameIn(std::string_view text);

/// Frame that the field array names; empty if there is none, or it is neither RAS nor LPS.
std::string FrameOf(vtkPolyData* surface);

/// Writes the field array; an empty frame changes nothing.
void SetFrame(const std::string& frame, vtkPolyData* surface);

/// A surface from RAS to LPS, or back: half a revolution about the third axis.
vtkSmartPointer<vtkPolyData> TurnedAboutZ(vtkPolyData* surface);

/// A line for a header or comment, as 3D Slicer writes it: "3D Slicer output. SPACE=RAS".
std::string FrameLine(const std::string& frame);
}

#endif
