// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoneView.h
 * @brief One view of one bone: its material, its light, its camera.
 */
#ifndef BoneDecimate_Applications_BoneView_h
#define BoneDecimate_Applications_BoneView_h

#include "DistanceColors.h"
#include "NamedLabels.h"
#include "Overlay.h"
#include "Viewpoint.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Part of a window, in its fractions.
struct Area
{
  Position LowerLeft;
  Position UpperRight;

  /// Width by height in pixels.
  double Aspect(vtkRenderWindow* window) const;
};

/// MergedTriangles() with point normals.
vtkSmartPointer<vtkPolyData> TrianglesWithNormals(vtkPolyData* surface);

/// Shaded smoothly, in the color of bone.
vtkSmartPointer<vtkActor> MakeBone(vtkPolyData* surface);

/// Each triangle in one shade: the staircase of a segmentation is seen, which shading across edges
/// hides.
void ShadeFlat(vtkActor* bone);

/// Flat triangles with their edges. @param lineWidth Pixels.
void ShowTriangles(vtkActor* bone, double lineWidth);

/// Colors of a scale by an array of the points.
void ColorByDistance(vtkActor* bone, const std::string& arrayName, const ColorScale& scale);

/// Each triangle in the color of the first of its labels, if there are several labels or one with a
/// color.
void ColorByLabel(vtkActor* bone, const std::vector<NamedLabel>& labels);

/// White behind everything that no view covers; has to come before the views.
void AddBackdrop(vtkRenderWindow* window);

/// A renderer of its own in that part of the window.
void AddView(vtkRenderWindow* window, const Area& area, vtkActor* bone, const Viewpoint& view,
  const Frame& frame);
}

#endif
