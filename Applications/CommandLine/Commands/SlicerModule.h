// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlicerModule.h
 * @brief The program as a command-line module of 3D Slicer.
 *
 *     bonedecimate --xml                                       the description
 *     bonedecimate --returnparameterfile FILE [OPTIONS] INPUT OUTPUT
 *                  [--roi x,y,z,rx,ry,rz] [--keep x,y,z]... [--keep_radius MM]
 *
 * Flags may be written with underscores (--max_error), since Slicer allows no dashes in them.
 * A region of interest is its center and half of its sides, mm; positions are in the coordinates of
 * the files (LPS in Slicer). Progress goes to the standard output in Slicer's tags, results as
 * "name = value" to FILE.
 */
#ifndef BoneDecimate_Applications_SlicerModule_h
#define BoneDecimate_Applications_SlicerModule_h

#include "ExitCode.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Whether the words are Slicer's.
bool IsSlicerCall(const std::vector<std::string>& words);

/// @throws Failure, std::bad_alloc
ExitCode RunSlicerCall(const std::vector<std::string>& words);
}

#endif
