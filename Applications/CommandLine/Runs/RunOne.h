// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOne.h
 * @brief One bone: read, decimate, write the requested files, print a summary.
 */
#ifndef BoneDecimate_Applications_RunOne_h
#define BoneDecimate_Applications_RunOne_h

#include "Arguments/Arguments.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace bonedecimate
{
/**
 * Either every requested file is there afterwards or none of them, with one exception: a picture
 * that could not be drawn does not take the others with it.
 * @return the result, with the report in its field data
 * @throws Failure, std::bad_alloc
 */
vtkSmartPointer<vtkPolyData> RunOne(const Arguments& arguments);
}

#endif
