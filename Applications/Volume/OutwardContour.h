// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutwardContour.h
 * @brief Flying edges, then from the grid to the patient.
 */
#ifndef BoneDecimate_Applications_OutwardContour_h
#define BoneDecimate_Applications_OutwardContour_h

#include "Volume.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace bonedecimate::volume
{
/// Points and triangles and nothing else; normals point to the smaller values, also where the
/// volume is mirrored.
vtkSmartPointer<vtkPolyData> OutwardContour(const Volume& volume, double value);

/// A voxel that is not a number would become a point that is none.
vtkIdType CountNotFinite(vtkDataArray* values);
}

#endif
