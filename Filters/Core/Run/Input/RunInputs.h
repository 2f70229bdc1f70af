// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunInputs.h
 * @brief What belongs to the input of a run, and what is wanted beside the surface.
 */
#ifndef BoneDecimate_Core_Run_Input_RunInputs_h
#define BoneDecimate_Core_Run_Input_RunInputs_h

#include "Figures/LeftOut.h"
#include "Geometry/Zone.h"
#include "Labels.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Levels/EditLog.h"

#include <array>
#include <optional>
#include <vector>

namespace bonedecimate
{
/// What a run knows if its input is a part of a larger surface, and other runs have the other parts.
struct SurfacePart
{
  /// Whether other parts have an input point, too, for each of them. It and the corners of its triangles are constrained, but by no
  /// tolerance: they may have been smoothed. Empty: none.
  std::vector<char> IsShared;
  /// mm, of each input point: where SmoothOnly has put it, of the whole surface. Edits start there and are proved against the
  /// input. Empty: nowhere. Otherwise the options must not smooth.
  std::vector<Vector3> SmoothedPoints;
  /// Where edits are allowed, mm; none: everywhere. New positions are inside, and vertices outside may only stay.
  std::optional<Zone> EditZone = {};
  /// What other parts have near this one, mm: faces that come within NeighborDistance (mm, above 0) of it stay, and new ones are
  /// farther away. Null: nothing.
  const Surface* Neighbors = nullptr;
  double NeighborDistance = 0.0; ///< mm
  /// The original of a part that is itself a result: the largest error then refers to it. It must have all that is within that
  /// error of what may change, and the part all that is near it. Null: the input. Not with smoothed points or tolerances; the run
  /// ends without a certificate, because both surfaces end somewhere else.
  const Surface* Reference = nullptr;
  const LabelMapSource* ReferenceLabels =
    nullptr; ///< Pairs of labels of its triangles; null: none.
  const Labels* ReferencePatches =
    nullptr; ///< Labels of its triangles (RunInputs::Labels); null: none.
  /// With a reference: edges, as pairs of points, at which the part and its original were cut out of the whole. Those of one
  /// triangle are no boundaries. Their ends must be shared or outside of the edit zone.
  std::vector<std::array<Index, 2>> CutEdges = {};
  std::vector<std::array<Index, 2>> ReferenceCutEdges = {}; ///< The same, of the reference.
};

class RegionCache;

/// What belongs to the input, and what is wanted beside the surface; none of it has to be there.
struct RunInputs
{
  /// Whether the input points were single precision: what PointsPrecision::Default means.
  bool InputIsSingle = false;
  /// Result::Origins: two look-ups for each output point and one for each output triangle.
  bool WantsOrigins = false;
  /// mm, of each input point, see Tolerances.h; null: MaximumError alone.
  const std::vector<double>* Tolerances = nullptr;
  /// Surface that the largest error is guaranteed, proved and measured against if it is not the input but its source
  /// (ReferenceInput.h). Tolerances still refer to the input.
  const Surface* Reference = nullptr;
  /// Labels of the input triangles: lines between different ones are collapsed along themselves alone, and every triangle keeps
  /// its own. With a log these lines do not change, because a log has no edits of several manifold patches at once.
  const bonedecimate::Labels* Labels = nullptr;
  /// mm, above 0, of each input point: what edges are to have there, at most EdgeLength (Run/Input/EdgeLengths.h). No effect
  /// without EdgeLength. Null: EdgeLength everywhere.
  const std::vector<double>* EdgeLengths = nullptr;
  /// The label map from which the input was extracted; null: not known. With a grid its voxels are guarded (KeepVoxels), and
  /// those of the result are compared with those of the input. Where pairs of labels differ, curves between them are collapsed
  /// along themselves alone, as between labels. Smoothing uses the grid points; without them it looks for the grid of a binary
  /// surface in its points.
  const LabelMapSource* LabelMap = nullptr;
  /// What of the input, or of the reference if there is one, was left out before. Null: nothing.
  const std::vector<LeftOutShape>* LeftOut = nullptr;
  /// Receives the record of the run, see Levels.h; not changed if the input was rejected.
  EditLog* Log = nullptr;
  /// Null: the input is the whole surface. Voxels of a part are not compared.
  const SurfacePart* Part = nullptr;
  /// Keeps what runs over regions of the same surface have in common (Partition/Regions/RegionCache.h). Null: nothing is kept.
  RegionCache* Regions = nullptr;
};
}

#endif
