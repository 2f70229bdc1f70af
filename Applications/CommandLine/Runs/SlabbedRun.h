// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabbedRun.h
 * @brief One bone, or the segments of a label map, from a volume that is larger than memory: read,
 * decimated and joined slab by slab.
 */
#ifndef BoneDecimate_Applications_SlabbedRun_h
#define BoneDecimate_Applications_SlabbedRun_h

#include "Arguments/Arguments.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace bonedecimate
{
/**
 * As RunOne(), if the memory of the arguments does not suffice for the whole.
 * @return Null if it does: nothing was done.
 * @throws Failure, std::bad_alloc
 */
vtkSmartPointer<vtkPolyData> RunInSlabs(const Arguments& arguments);
}

#endif
