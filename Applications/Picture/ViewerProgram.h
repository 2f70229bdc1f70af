// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ViewerProgram.h
 * @brief The program of the interactive view: vtk.js and the modules in Viewer/ as one script.
 */
#ifndef BoneDecimate_Applications_ViewerProgram_h
#define BoneDecimate_Applications_ViewerProgram_h

namespace bonedecimate
{
/// JavaScript; empty if it could not be made when the program was built (Viewer/bundle.cmake).
extern const char* const ViewerProgram;
}

#endif
