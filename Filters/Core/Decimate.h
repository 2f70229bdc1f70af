// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Decimate.h
 * @brief The core's one entry: a surface in, a smaller surface with its error in millimetres out.
 *
 *     cleaned  = Clean(input)                    refuse, merge, drop, count
 *     mesh     = HalfEdgeMesh(cleaned)           lock what is not manifold
 *     original = Original(cleaned)               nearest point by a bounding tree
 *     ThesisLoop or FastLoop                     collapse until a stop is reached
 *     result   = Extract(mesh)                   points, triangles, maps
 *     Measure(result, original)                  both directions
 *
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen 2018: the loop.
 */
#ifndef BoneDecimate_Core_Decimate_h
#define BoneDecimate_Core_Decimate_h

#include "Monitor.h"
#include "Options.h"
#include "Report.h"
#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// Where each output point lies on the input: one entry per output point, ids are those of the input arrays.
struct PointOrigins
{
  std::vector<Index> NearestTriangle;             ///< Input triangle nearest to the output point.
  std::vector<std::array<double, 3>> Barycentric; ///< Of the nearest place in that triangle, sum 1.
  std::vector<Index> NearestPoint;                ///< Input point nearest to the output point.
};

struct Result
{
  bonedecimate::Surface Surface; ///< Empty if the input was refused.
  PointOrigins Origins;
  std::vector<double> Distance; ///< mm, of each output point to the input surface.
  std::vector<double>
    RunningError; ///< mm, largest distance recorded along the collapses into each output point.
  std::vector<Index> PointCount; ///< How many input points each output point stands for.
  std::vector<double>
    InputDistance; ///< mm, of each input point to the result; only with MeasureInputDistances.
  bonedecimate::Report Report;
};

/**
 * @param input Points in mm and triangles; nothing is changed. Anything may be wrong with it: see InputStatus.
 * @param inputIsSingle Whether the input points were single precision (what PointsPrecision::Default means).
 * @throws std::bad_alloc and nothing else.
 */
Result Decimate(const Surface& input, const Options& options, const Monitor& monitor = {},
  bool inputIsSingle = false);
}

#endif
