// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Viewpoint.h
 * @brief Where the camera stands, by rules alone: the same bone always gives the same picture.
 */
#ifndef BoneDecimate_Applications_Viewpoint_h
#define BoneDecimate_Applications_Viewpoint_h

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <array>

namespace bonedecimate
{
/// Unit vectors; coordinates are taken as LPS: x to the patient's left, y to the back, z to the
/// head.
struct Viewpoint
{
  std::array<double, 3> ToViewer;
  std::array<double, 3> Right; ///< Right of the picture, not of the patient.
  std::array<double, 3> Up;
};

/// What a parallel camera shows, mm.
struct Frame
{
  std::array<double, 3> Center;
  double HalfHeight;
};

/**
 * From the front, a little from above and from one side: the side from which more of the distance
 * faces the viewer.
 * @param surface A surface of triangles. @param distances Distances of its points, mm; may be null.
 */
Viewpoint ChooseViewpoint(vtkPolyData* surface, vtkDataArray* distances);

/// The whole surface. @param aspect Width of the view by its height.
Frame FrameWhole(const Viewpoint& view, vtkPolyData* surface, double aspect);

/**
 * A square of about that width (mm) in which the distances seen by the viewer are largest on
 * the whole, so that one odd point alone does not decide. Without distances: the middle of what
 * faces the viewer.
 * @param surface Triangles with point normals.
 */
Frame FrameCloseUp(
  const Viewpoint& view, vtkPolyData* surface, vtkDataArray* distances, double width);

/// A camera, and what is before a point of a surface.
struct PointView
{
  Viewpoint View;
  double Free; ///< mm between the point and the nearest part that hides it; infinite: none does.
};

/// The preferred view if it shows a point well, or else one from another side: the one that shows
/// it best or, if none does, in which most is free before it. @param surface Triangles.
PointView ChooseViewOfPoint(
  const Viewpoint& preferred, vtkPolyData* surface, const std::array<double, 3>& point);

/// Mean length of an edge, mm, if the triangles were all equilateral.
double TypicalEdge(vtkPolyData* surface);
}

#endif
