// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputFigures.h
 * @brief What was found about the input and done to it before the first edit.
 */
#ifndef BoneDecimate_Core_Figures_InputFigures_h
#define BoneDecimate_Core_Figures_InputFigures_h

#include "DistanceFigures.h"
#include "Geometry/Surface.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Counts of cleaning. "First" are input ids, -1 if there is none.
struct CleaningStatistics
{
  std::int64_t TrianglesRead = 0;
  std::int64_t PointsRead = 0;
  std::int64_t NonFinitePoints = 0;
  std::int64_t FirstNonFinitePoint = -1;
  std::int64_t HugePoints = 0; ///< With a coordinate beyond 1e30.
  std::int64_t FirstHugePoint = -1;
  std::int64_t TrianglesOutOfRange = 0;
  std::int64_t FirstTriangleOutOfRange = -1;
  std::int64_t MergedPoints = 0;
  std::int64_t UnusedPoints = 0;
  std::int64_t DroppedTriangles = 0; ///< Without area.
  std::int64_t FirstDroppedTriangle = -1;
  std::int64_t NonManifoldPoints = 0; ///< On non-manifold edges or pinched.
  std::int64_t FirstNonManifoldPoint = -1;
  std::int64_t BadTolerances = 0; ///< NaN or beyond 1e30 mm.
  std::int64_t FirstBadTolerance = -1;
  std::int64_t BadEdgeLengths = 0; ///< Not above 0, NaN or beyond 1e30 mm.
  std::int64_t FirstBadEdgeLength = -1;
  /// After merging: points that rounding to single precision moves farther than allowed.
  std::int64_t CoarsePoints = 0;
  /// Points of the result at the same position as another one in single precision.
  std::int64_t MeetingPoints = 0;
  std::int64_t FirstCoarsePoint = -1;
  double MaxRounding = 0.0;           ///< mm, of those points.
  std::int64_t ConstrainedPoints = 0; ///< Points, after merging, whose tolerance is 0.
};

/// The reference to which the largest error refers, if it is not the input.
struct ReferenceFigures
{
  bool IsPresent = false; ///< If false, all other members are meaningless.
  std::int64_t Faces = 0;
  std::uint64_t Checksum = 0; ///< Computed like that of the input.
  ProvedDistance ToInput;     ///< mm, between reference and input, the larger direction.
};

/// What welding changed before the first edit (WeldOperation.h).
struct WeldFigures
{
  bool HasRun = false;     ///< If false, all other members are meaningless.
  std::int64_t Points = 0; ///< How many moved.
  double Movement = 0.0;   ///< mm, how far one moved at most; part of what is proved.
};

/// A component that was removed by pruning.
struct PrunedComponent
{
  std::int64_t Triangles = 0;
  double Size = 0.0;                ///< mm, the longest side of its box along the axes.
  double Area = 0.0;                ///< mm^2
  double Volume = 0.0;              ///< mm^3, NaN if it is not closed.
  Vector3 Center = Vector3::Zero(); ///< mm, the middle of the box.
};

struct PruneFigures
{
  bool IsRequested = false; ///< If false, all other members are meaningless.
  bool TookAll = false;     ///< The input was rejected.
  std::int64_t Triangles = 0;
  std::vector<PrunedComponent> Components; ///< Sorted, largest first.
};

/// The size of the input, and the largest error compared with it.
struct SizeFigures
{
  double Diagonal = 0.0;   ///< mm, of the bounding box of the input's triangles, after pruning.
  double MaxError = 0.0;   ///< mm, of MaximumError, the preset or the tolerances; 0: none.
  std::int64_t Point = -1; ///< The input point whose tolerance is MaxError; -1: none.
  double ErrorBound = 0.0; ///< mm, the error used by the run: at most Diagonal.
};

/// The voxels of a run with an ErrorPreset.
struct VoxelFigures
{
  enum class Source : int
  {
    NotRequested = 0,
    Input,
    Grid, ///< Estimated from the planes of marching cubes.
    Edges ///< Estimated from the lengths of edges.
  };
  Source From = Source::NotRequested;
  double Size = 0.0;     ///< mm, the least side.
  double Error = 0.0;    ///< mm, uncertainty of an estimate.
  double MaxError = 0.0; ///< mm, of the preset, or a smaller MaximumError.
};

/// The area of the triangles of one label, mm^2.
struct LabelArea
{
  std::string Name;
  double Input = 0.0;
  double Output = 0.0;
  /// Relative to the input area; 0 if that is 0.
  double Change() const { return Input > 0.0 ? std::abs(Output - Input) / Input : 0.0; }
};

/// The largest relative change of the area of a label; 0 without labels.
double MaxLabelChange(const std::vector<LabelArea>& labels);
}

#endif
