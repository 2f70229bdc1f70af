// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComponentCensus.h
 * @brief Number of triangles, box, area and volume of each component, also of surfaces of which
 * several runs have a part each.
 *
 *     part      components connected by common points, each with its figures, and where it has
 *               points and edges that other parts may have, too (shared positions)
 *     joined    components of several parts with a common position are one; an edge of two parts
 *               closes both if it has two triangles of opposite directions
 */
#ifndef BoneDecimate_Core_Run_Input_ComponentCensus_h
#define BoneDecimate_Core_Run_Input_ComponentCensus_h

#include "Figures/InputFigures.h"
#include "Geometry/Surface.h"
#include "Mesh/Cleaning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// mm, in ascending order, each once; the same list for all parts.
using SharedPositions = std::vector<std::array<double, 3>>;

struct CensusOfPart
{
  struct Component
  {
    std::int64_t Triangles = 0;
    double Area = 0.0;         ///< mm^2
    double Volume = 0.0;       ///< mm^3, signed, between its triangles and the origin.
    bool IsOpen = false;       ///< Whether an edge that no other part can have has no twin.
    std::array<double, 6> Box; ///< mm from the origin, the low corner and the high one.
  };
  std::vector<Index> OfTriangle; ///< The component of each cleaned triangle.
  std::vector<Component> All;
  std::vector<std::array<Index, 2>> Points; ///< Shared position and component.
  std::vector<std::array<Index, 3>> Edges;  ///< From and to, shared positions, and component.
};

struct JoinedCensus
{
  /// The joined component of each component of each part.
  std::vector<std::vector<Index>> OfComponent;
  std::vector<PrunedComponent> All;
};

/// @param input That was cleaned.  @param origin mm, the same for all parts.
CensusOfPart TakeCensus(const Surface& input, const CleanSurface& clean, const Vector3& origin,
  const SharedPositions& shared, int threads);

/// The same of a surface that is not clean. OfTriangle is then of each input triangle, None of
/// those that cleaning drops. Nothing if the surface cannot be used.
CensusOfPart TakeCensus(
  const Surface& input, const Vector3& origin, const SharedPositions& shared, int threads);

JoinedCensus JoinCensus(const std::vector<CensusOfPart>& parts, const Vector3& origin);

/// As numbers, to be sent to another process of this program; without OfTriangle.
std::vector<double> NumbersOf(const CensusOfPart& part);
CensusOfPart CensusFrom(const std::vector<double>& numbers);
}

#endif
