// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutwardContour.h
 * @brief Flying edges, then from the grid to the patient.
 */
#ifndef BoneDecimate_Applications_OutwardContour_h
#define BoneDecimate_Applications_OutwardContour_h

#include "Volume.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace bonedecimate::volume
{
/**
 * Points and triangles with three different corners, and nothing else; normals point to the smaller
 * values, also where the volume is mirrored. Of a slab (SlabReader.h) these are the triangles of
 * the whole between its first and its last layer, with the same coordinates bit for bit.
 */
vtkSmartPointer<vtkPolyData> OutwardContour(const Volume& volume, double value);

/// Counts, for each layer of a volume or slab, the points of the contour in it and between it and
/// the next one. There are about twice as many triangles.
std::vector<std::int64_t> CountContourPoints(const Volume& slab, double value);
}

#endif
