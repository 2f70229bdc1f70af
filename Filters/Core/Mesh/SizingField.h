// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SizingField.h
 * @brief The requested edge length at each position: that at the nearest point of a surface.
 */
#ifndef BoneDecimate_Core_Mesh_SizingField_h
#define BoneDecimate_Core_Mesh_SizingField_h

#include "Geometry/BoundingTree.h"
#include "Geometry/Surface.h"
#include "PointGraph.h"

#include <vector>

namespace bonedecimate
{
class SizingField
{
public:
  /// @param surface At least one triangle.  @param lengths mm, above 0, one per point.
  SizingField(const Surface& surface, std::vector<double> lengths, int threads);

  struct LocalLength
  {
    double Length; ///< mm, linear on each triangle.
    Index Triangle;
  };
  /// @param hint A triangle near the position; changes the time, never the result.
  LocalLength At(const Vector3& position, Index hint = None) const;

  double MinLength() const { return this->ShortestLength; } ///< mm

private:
  BoundingTree Tree;
  std::vector<Triangle> Triangles;
  std::vector<double> Lengths; // mm
  double ShortestLength;       // mm
};

/// Shortens lengths so that along an edge of the graph, the length at one end exceeds that at the
/// other by no more than slope times the edge.
/// @param lengths mm, one per point.
void GradeLengths(
  const Surface& surface, const PointGraph& graph, double slope, std::vector<double>& lengths);
}

#endif
