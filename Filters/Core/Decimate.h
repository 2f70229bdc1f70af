// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Decimate.h
 * @brief The core's one entry: a surface in, a smaller surface with its error in millimetres out.
 *
 *     cleaned  = Clean(input)                    refuse, merge, drop, count
 *     Prune(cleaned)                             components that are too small, on request
 *     CompareWithReference(input)                what is left of the largest error, if the input is itself a result
 *     SortAlongCurve(cleaned)                    neighbours in space become neighbours in memory
 *     mesh     = HalfEdgeMesh(cleaned)           split where it is not manifold, freeze what has a tolerance of 0
 *     original = Original(cleaned)               nearest point by a bounding tree, built when needed
 *     ThesisLoop, Sweep or RelaxedLoop           collapse until a stop is reached
 *     result   = Extract(mesh)                   points, triangles, maps
 *     Judge(result, original)                    both directions, open borders
 *     ProveResult(input, result)                 the certificate, if there is a largest error
 *
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen 2018: the loop.
 */
#ifndef BoneDecimate_Core_Decimate_h
#define BoneDecimate_Core_Decimate_h

#include "Labels.h"
#include "Levels/EditLog.h"
#include "Monitor.h"
#include "Options.h"
#include "Report.h"
#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// Where output and input lie on each other. Empty unless asked for.
struct SurfaceOrigins
{
  std::vector<Index> NearestTriangle;             ///< Input triangle nearest to each output point.
  std::vector<std::array<double, 3>> Barycentric; ///< Of the nearest place in that triangle, sum 1.
  std::vector<Index> NearestPoint;                ///< Input point nearest to each output point.
  std::vector<Index>
    TriangleAtCentroid; ///< Input triangle nearest to each output triangle's centroid; one of its label.
  std::vector<Index>
    OutputPoint; ///< Of each input point: the one it became part of, None if no triangle used it.
};

struct Result
{
  /// Empty if the input was refused. Points and triangles come in the order of SpatialOrder.h.
  bonedecimate::Surface Surface;
  SurfaceOrigins Origins;
  /// mm, of each output point to the input surface, or to the reference if distances are measured; filled with
  /// MeasureDistances, with Origins, and whenever distances are recorded along the collapses (Thesis), else empty; empty,
  /// too, in a run aborted before.
  std::vector<double> Distance;
  /// mm, largest distance recorded along the collapses into each output point, or Distance if none are; filled with it.
  std::vector<double> RunningError;
  std::vector<Index> PointCount; ///< How many input points each output point stands for.
  std::vector<double>
    InputDistance; ///< mm, of each input point to the result; only with MeasureInputDistances.
  /// mm, proved: no point of the triangles around an output point is farther from the input. Empty without a proof.
  std::vector<double> ErrorBound;
  /// mm, the same of each input point, not a number where there is no triangle; only with MeasureInputDistances and
  /// without a reference.
  std::vector<double> InputErrorBound;
  bonedecimate::Report Report;
};

/// What belongs to the input, and what is wanted beside the surface; none of it has to be there.
struct Companions
{
  /// Whether the input points were single precision: what PointsPrecision::Default means.
  bool InputIsSingle = false;
  /// Result::Origins: two look-ups for each output point and one for each output triangle.
  bool WantsOrigins = false;
  /// mm, of each input point, see Tolerances.h; null: MaximumError alone.
  const std::vector<double>* Tolerances = nullptr;
  /// What the largest error is promised, proved and measured against, if that is not the input but what it was made from
  /// (ReferenceInput.h); the tolerances stay those against the input.
  const Surface* Reference = nullptr;
  /// Of the input triangles: lines between different ones are collapsed along themselves alone, and every triangle keeps
  /// its own. Not together with a log.
  const bonedecimate::Labels* Labels = nullptr;
  /// Where the run is to be recorded, see Levels.h; not changed if the input was refused.
  EditLog* Log = nullptr;
};

/**
 * @param input Points in mm and triangles; nothing is changed. Anything may be wrong with it: see InputStatus.
 * @throws std::bad_alloc and nothing else.
 */
Result Decimate(const Surface& input, const Options& options, const Monitor& monitor = {},
  const Companions& companions = {});
}

#endif
