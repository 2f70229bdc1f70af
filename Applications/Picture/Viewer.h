// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Viewer.h
 * @brief The interactive view of a page: vtk.js, the surfaces and the modules in Viewer/, all in
 * the page itself.
 */
#ifndef BoneDecimate_Applications_Viewer_h
#define BoneDecimate_Applications_Viewer_h

#include "FarthestPoints.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct ViewerSurface
{
  vtkSmartPointer<vtkPolyData> Surface;
  std::string DistanceArrayName; ///< Point array of distances, mm; empty: none.
  std::string Caption;           ///< Text behind the number of triangles; may be empty.
};

/// Returns a surface with at most that many triangles and the arrays of the given one.
using SurfaceReducer =
  std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData* surface, vtkIdType triangles)>;

struct ViewerSubject
{
  ViewerSurface Before;
  /// At least one, from coarse to fine. Labels are those of the last.
  std::vector<ViewerSurface> Levels;
  double Tolerance = 0.0; ///< As that of ColorScale.
  std::array<std::string, 2> Names{ "Before",
    "After" };                    ///< What the view calls Before and the levels.
  std::vector<FarPoint> Farthest; ///< To jump to, while the last level is shown; may be empty.
  std::string Frame;              ///< "LPS" or "RAS"; empty: the axes are x, y and z.
  std::string Legend = "distance to the other surface, mm"; ///< Title of the color scale.
  std::size_t MostBytes = 20000000; ///< Largest size of what the view adds to the page.
  SurfaceReducer Reduce; ///< For surfaces that are too large; empty: they are carried whole.
};

/// The parts of a page, HTML; both empty if the program was built without the view.
struct ViewerHtml
{
  std::string Section; ///< In the body.
  std::string Script;  ///< At its end.
};

/// Whether the program was built with the view.
bool HasViewer();

/// Composes the view. The same surfaces give the same bytes.
ViewerHtml ComposeViewer(const ViewerSubject& subject);
}

#endif
