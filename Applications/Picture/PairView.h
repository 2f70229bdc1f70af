// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairView.h
 * @brief Where two surfaces are apart: the parts of a page that show it.
 */
#ifndef BoneDecimate_Applications_PairView_h
#define BoneDecimate_Applications_PairView_h

#include "FarthestPoints.h"
#include "Viewer.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct PairSubject
{
  vtkPolyData* Result = nullptr;
  vtkSmartPointer<vtkPolyData> Before; ///< May be null.
  std::string DistanceArrayName;       ///< On Before, mm, of each point.
  std::string ResultDistanceArrayName; ///< On Result, mm, of each point.
  /// From Before to Result and back; empty: as the report of Result says.
  std::optional<std::array<LargestDistance, 2>> Largest;
  SurfaceReducer Reduce;  ///< For the interactive view of surfaces that are too large for a page.
  std::string Frame;      ///< Axes of the coordinates, "LPS" or "RAS"; empty: not known.
  double Tolerance = 0.0; ///< As that of ColorScale.
  std::array<std::string, 2> Names{ "Before", "After" }; ///< What the view calls the two.
};

/// Empty without both surfaces.
ViewerHtml PairViewer(
  const PairSubject& subject, const std::vector<FarPoint>& points, std::size_t bytesOfPicture);

/// Empty without both surfaces.
std::vector<FarPoint> FarthestOfPair(const PairSubject& subject);

/// A table of the points; empty without points.
/// @param surfaces What the page calls the original and the result.
std::string WhereSection(const std::vector<FarPoint>& points, const std::string& frame,
  const std::array<std::string, 2>& surfaces);
}

#endif
