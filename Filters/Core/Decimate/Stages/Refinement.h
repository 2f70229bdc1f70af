// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refinement.h
 * @brief Fits the mesh after the collapse to samples of the original by edge flips and moves of
 * vertices.
 *
 *     Begin:       distribute the samples over the faces
 *     Sweep:       let the samples settle  ->  flip edges  ->  move vertices
 *     CollapseTo:  let the samples settle  ->  the last collapses by the sampled error
 *
 * Sweeps change neither the number of triangles, the topology, open boundaries nor constrained
 * parts.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_Refinement_h
#define BoneDecimate_Core_Decimate_Stages_Refinement_h

#include "SampledRefinement.h"

namespace bonedecimate
{
class Refinement : public SampledRefinement
{
public:
  /// @param original The mesh before the first collapse; must not change.
  /// @param shapeWeight The weight of Decimate/Cost/SampledErrorCost.h; treated as 0 if a bound or
  /// voxels limit the edits.
  Refinement(Editor& editor, const HalfEdgeMesh& original, double shapeWeight, int threads);

  /// Monitors receive fractions from 0 to 1. False if the monitor requests a stop; the surface is
  /// valid then, too.
  bool Sweep(int times, const Monitor& monitor);
  /// @param edgesOfCollapse Number of edges evaluated per remaining collapse.
  bool CollapseTo(Index faces, int edgesOfCollapse, const Monitor& monitor);

private:
  bool FlipEdges(const Monitor& monitor);
  bool MoveVertices(const Monitor& monitor);
};
}

#endif
