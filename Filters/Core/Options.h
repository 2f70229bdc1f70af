// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Options.h
 * @brief What a run may be asked for. Meaning, range and unit of each stand in OptionTable.cxx.
 */
#ifndef BoneDecimate_Core_Options_h
#define BoneDecimate_Core_Options_h

#include <string>

namespace bonedecimate
{
enum class Mode : int
{
  Thesis = 0,   ///< Vertex-driven collapse by normal field deviation (Brandao 2018).
  Fast = 1,     ///< Ordered by the deviation that a collapse causes, in O(1) an edge.
  Balanced = 2, ///< Fast nearly to the end, then fitted to samples of the original.
  Accurate = 3  ///< As Balanced, with more collapses by sampled distance and more sweeps.
};

/// The values are those of vtkAlgorithm::DesiredOutputPrecision.
enum class PointsPrecision : int
{
  Single = 0,
  Double = 1,
  Default = 2 ///< That of the input points.
};

/// A largest error as a share of the scan's voxels.
enum class ErrorPreset : int
{
  NoPreset = 0,
  QuarterVoxel = 1,
  HalfVoxel = 2,
  OneVoxel = 3
};

/// Every field is one row of OptionTable(); the defaults are written here and nowhere else.
struct Options
{
  bonedecimate::Mode Mode = bonedecimate::Mode::Balanced;
  int TargetNumberOfTriangles = 0;
  double TargetReduction = 0.9;
  double MaximumError = 0.0; // mm
  bool AllowLargeError = false;
  bool KeepClearance = true;
  double NormalTolerance = 0.95;
  bool AutomaticNormalTolerance = false;
  bool MergePoints = true;
  bool MeasureDistances = true;
  bool MeasureInputDistances = false;
  int NumberOfThreads = 0;
  PointsPrecision OutputPointsPrecision = PointsPrecision::Default;
  bool PassArrays = true;
  bool MakeMaps = false;
  bool RecomputeNormals = false;
  std::string DistanceArrayName = "Distance";
  std::string RunningErrorArrayName = "RunningError";
  std::string PointCountArrayName = "InputPointCount";
  std::string InputDistanceArrayName = "DistanceToResult";
  std::string ToleranceArrayName;
  std::string LabelArrayName;
  bool ProveResult = true;
  std::string ErrorBoundArrayName = "ErrorBound";
  std::string InputErrorBoundArrayName = "ErrorBoundToResult";
  bonedecimate::ErrorPreset ErrorPreset = bonedecimate::ErrorPreset::NoPreset;
  double VoxelSize = 0.0;   // mm
  double PruneSize = 0.0;   // mm
  double PruneArea = 0.0;   // mm^2
  double PruneVolume = 0.0; // mm^3
  int PruneTriangles = 0;
  bool ExamineInput = false;

  /// Set by whoever sets TargetReduction. While it is false, the default reduction steps back as soon as a
  /// number of triangles or a largest error is asked for.
  bool TargetReductionIsExplicit = false;

  /// Whether small components are to go.
  bool Prunes() const
  {
    return this->PruneSize > 0.0 || this->PruneArea > 0.0 || this->PruneVolume > 0.0 ||
      this->PruneTriangles > 0;
  }

  /// Whether MaximumError is a promise about every point of both surfaces.
  bool PromisesError() const
  {
    return this->Mode != bonedecimate::Mode::Thesis &&
      (this->MaximumError > 0.0 || this->ErrorPreset != bonedecimate::ErrorPreset::NoPreset);
  }
};
}

#endif
