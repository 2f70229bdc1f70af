// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contest.h
 * @brief The modes of vtkBoneDecimate and vtkQuadricDecimation on the same surface in the same process, measured by the same hand.
 */
#ifndef BoneDecimate_Testing_Contest_h
#define BoneDecimate_Testing_Contest_h

#include "Report.h"

#include "vtkPolyData.h"

/// What came out and what it cost.
struct Outcome
{
  bonedecimate::SurfaceStatistics Surface;
  bonedecimate::DistanceStatistics There; ///< Result to input, mm.
  bonedecimate::DistanceStatistics Back;  ///< Input to result, mm.
  double Seconds = 0.0;                   ///< Of the decimation alone, the median of the rounds.
  double Megabytes = 0.0;                 ///< Peak beyond what was held before.
};

struct Standings
{
  Outcome Thesis;
  Outcome Fast;
  Outcome Vtk;
};

/// All to that number of triangles, in turn, `rounds` times.
Standings ContestToCount(vtkPolyData* bone, int triangles, int rounds);

/// Thesis mode to that distance; the others are asked for the number of triangles that came out.
Standings ContestToError(vtkPolyData* bone, double millimetres, int rounds);

#endif
