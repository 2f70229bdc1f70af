// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PageSurfaces.h
 * @brief What pages need of surfaces besides the result of a run.
 */
#ifndef BoneDecimate_Applications_PageSurfaces_h
#define BoneDecimate_Applications_PageSurfaces_h

#include "Page.h"

#include "vtkBoneDecimate.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace bonedecimate
{
/// The input as the run has taken it: its copy with distances, without the triangles of pruned
/// components.
vtkSmartPointer<vtkPolyData> SurfaceBefore(vtkBoneDecimate* filter);

/// What the outputs of a run give its page.
PageSubject PageOfRun(vtkBoneDecimate* filter);

/// In mode Fast, with the arrays of the surface. @returns The surface itself if it cannot be
/// reduced.
vtkSmartPointer<vtkPolyData> ReduceForPage(vtkPolyData* surface, vtkIdType triangles);

/// The surface with the lengths of signed distances of its points as another array. The surface
/// itself if it has no such distances.
vtkSmartPointer<vtkPolyData> WithoutSigns(
  vtkPolyData* surface, const std::string& signedName, const std::string& arrayName);

/// The surface with the distance of each point to the triangles of another one, mm.
vtkSmartPointer<vtkPolyData> WithDistances(
  vtkPolyData* surface, vtkPolyData* other, const std::string& arrayName);
}

#endif
