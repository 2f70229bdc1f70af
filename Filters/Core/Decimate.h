// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Decimate.h
 * @brief Simplifies a surface; the result comes with its error in millimeters.
 *
 *     welded   = Weld(input)                   on request; bounds of what follows are widened (WeldRun.h)
 *     closed   = CloseTunnels(welded)          on request; what follows refers to the closed surface (TunnelRun.h)
 *     prepared = PrepareInput(input)           clean, prune, check the errors, build the half-edge mesh
 *     smoothed = SmoothInput(prepared)         positions within a bound, if smoothing is on; proved by their displacement
 *     editor   = MakeEditor(prepared)          the mesh with all that is kept beside it; proves edits if there is a bound
 *     RunStages(editor)                        the stages of the mode (Modes.h), until a target is reached
 *     SeparatePoints(editor)                   points of a proved result that rounding would merge
 *     result   = ExtractResult(editor)         points, triangles, maps
 *     Evaluate(result)                         statistics, distances in both directions, open boundaries
 *     ProveResult(input, result)               the certificate, if there is a bound
 *
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen 2018: the loop.
 */
#ifndef BoneDecimate_Core_Decimate_h
#define BoneDecimate_Core_Decimate_h

#include "Geometry/Zone.h"
#include "Input/Labels.h"
#include "LabelMap/VoxelGrid.h"
#include "Levels/EditLog.h"
#include "Monitor.h"
#include "Options/Options.h"
#include "Report/Report.h"
#include "Surface.h"

#include <array>
#include <optional>
#include <vector>

namespace bonedecimate
{
/// Correspondence between output and input. Empty unless requested. If the triangles are those of the input, as after smoothing
/// alone, each point and triangle corresponds to itself, even if another one is nearer.
struct SurfaceOrigins
{
  std::vector<Index> NearestTriangle;             ///< Input triangle nearest to each output point.
  std::vector<std::array<double, 3>> Barycentric; ///< Of the nearest point in that triangle, sum 1.
  std::vector<Index> NearestPoint;                ///< Input point nearest to each output point.
  std::vector<Index>
    TriangleAtCentroid; ///< Input triangle nearest to each output triangle's centroid; one of its label.
  std::vector<Index>
    OutputPoint; ///< Of each input point: the one it became part of, None if no triangle used it.
};

/// What a run made of a surface.
struct Result
{
  /// Empty if the input was rejected. Points and triangles come in the order of SpatialOrder.h; if only regions were run, in
  /// that of Regions/JoinRegions.h.
  bonedecimate::Surface Surface;
  SurfaceOrigins Origins; ///< Where the output comes from; filled on request.
  /// mm, of each output point to the input surface, or to the reference if distances are measured; filled with
  /// MeasureDistances, with Origins, and in modes that record distances along the collapses, else empty; empty,
  /// too, in a run aborted before.
  std::vector<double> Distance;
  /// mm, largest distance recorded along the collapses into each output point, or Distance if none are; filled with it.
  std::vector<double> RunningError;
  /// Of each output triangle; filled if the label map has them.
  std::vector<bonedecimate::BoundaryLabels> BoundaryLabels;
  std::vector<Index> PointCount; ///< Number of input points that each output point represents.
  std::vector<double>
    InputDistance; ///< mm, of each input point to the result; only with MeasureInputDistances.
  /// mm, proved: no point of the triangles around an output point is farther from the input. Empty without a proof.
  std::vector<double> ErrorBound;
  /// mm, the same of each input point, not a number where there is no triangle; only with MeasureInputDistances and
  /// without a reference.
  std::vector<double> InputErrorBound;
  bonedecimate::Report Report; ///< Status, figures and warnings of the run.
};

/// What a run knows if its input is a part of a larger surface, and other runs have the other parts.
struct SurfacePart
{
  /// Of each input point: whether other parts have it, too. It and the corners of its triangles are constrained, but by no
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
  /// Of the input triangles: lines between different ones are collapsed along themselves alone, and every triangle keeps
  /// its own. With a log these lines do not change, because a log has no edits of several manifold patches at once.
  const bonedecimate::Labels* Labels = nullptr;
  /// mm, above 0, of each input point: what edges are to have there, at most EdgeLength (Input/EdgeLengths.h). No effect
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
  /// Keeps what runs over regions of the same surface have in common (Regions/RegionCache.h). Null: nothing is kept.
  RegionCache* Regions = nullptr;
};

/**
 * Where most points have a tolerance of 0, only the regions around the others are run (Regions/RegionRun.h).
 * @param input Points in mm and triangles; nothing is changed. Anything may be wrong with it: see InputStatus.
 * @throws std::bad_alloc and nothing else.
 */
Result Decimate(const Surface& input, const Options& options, const Monitor& monitor = {},
  const RunInputs& inputs = {});

/// The points of the input as the first edit of Decimate would find them.
struct SmoothedInput
{
  std::vector<Vector3>
    Points; ///< mm, of each input point. Those of the input if it was rejected or nothing is smoothed.
  bonedecimate::Report Report; ///< Status, smoothing and parts alone.
};

/// @param inputs As those of Decimate.
SmoothedInput SmoothOnly(const Surface& input, const Options& options, const Monitor& monitor = {},
  const RunInputs& inputs = {});
}

#endif
