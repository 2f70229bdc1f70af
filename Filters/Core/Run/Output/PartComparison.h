// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartComparison.h
 * @brief Compares the parts of input and result: area, volume and thickness.
 *
 *     parts     with pairs of labels: what each label encloses; with labels: the triangles of
 *               each; otherwise the components
 *     faces     of the result keep the part that they had in the input
 */
#ifndef BoneDecimate_Core_Run_Output_PartComparison_h
#define BoneDecimate_Core_Run_Output_PartComparison_h

#include "Figures/PartFigures.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/SurfaceParts.h"
#include "Run/Input/RunInputs.h"

#include <string>
#include <vector>

namespace bonedecimate
{
class BoundingTree;

class PartComparer
{
public:
  /// @param clean Must outlive this.
  PartComparer(const CleanSurface& clean, const RunInputs& inputs);

  /// @param result mm from the local origin; the remaining faces, in the order of the mesh.
  PartComparison Compare(const HalfEdgeMesh& mesh, const Surface& result, double smallestVolume);

  /// After Compare.  @param before,after Trees of the cleaned input and of the result.
  void MeasureThickness(const BoundingTree& before, const BoundingTree& after,
    const Surface& result, int threads, PartComparison& compared) const;

private:
  void Describe(const std::vector<PartExtent>& extents, PartComparison& compared);

  const CleanSurface& Clean;
  PartComparison::Kind Kind = PartComparison::Kind::Components;
  bool EncloseLabels = false;      // whether triangles have parts on both sides
  std::vector<std::string> Labels; // names, unless the parts are components
  SurfaceParts Before, After;
  std::vector<Index> Order; // of the parts, as in the comparison
};
}

#endif
