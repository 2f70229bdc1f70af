// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Needs.h
 * @brief What an option needs to have an effect: of other options, or of the run.
 *
 * A row of the table of options lists its needs. Needs of the first kind have a predicate of the
 * options (NeedTable()); an option that was set while one of them is not met is reported
 * (UnmetNeeds.h). Needs of the second kind are offered by every run, except by the kinds of run
 * whose row says that they lack them (RunKinds.h).
 */
#ifndef BoneDecimate_Core_Options_Needs_h
#define BoneDecimate_Core_Options_Needs_h

#include <string>
#include <vector>

namespace bonedecimate
{
struct Options;

enum class Need : int
{
  /// @name Met by other options, see NeedTable(). @{
  Bound,
  Limit,
  ProvableError,
  Proof,
  ProvingMode,
  RefiningMode,
  ShapeMode,
  NormalToleranceMode,
  Count,
  RemovedTriangles,
  EdgeLength,
  ErrorPreset,
  Smoothing,
  NoSmoothingDistance,
  FixedNormalTolerance,
  Measured,
  InputDistances,
  /// @}

  /// @name Offered by a run. @{
  Edits, ///< Triangles are removed.
  /// The number of triangles of the whole surface is known, so that it can end the run.
  TargetCount,
  SingleRun,          ///< There is one run, with an error and an end that the user sets.
  SmoothingChoice,    ///< The distance of smoothing is an option.
  VoxelLengths,       ///< Lengths and edits can follow the voxels of the scan.
  VoxelSize,          ///< The voxel size is given or can be found.
  KeptVoxels,         ///< Edits can keep the label of every voxel.
  GradedLengths,      ///< Edge lengths are graded along the whole surface.
  SeparatePoints,     ///< Points with equal coordinates may stay apart.
  Components,         ///< Whole components are known, so that small ones can be removed.
  TriangleComponents, ///< The same by their number of triangles.
  Tunnels,     ///< The whole surface is known before the first edit, and nothing else refers to it.
  Welding,     ///< The same for open boundaries, which are welded before the first edit.
  Diagnostics, ///< The input can be diagnosed.
  InputOutput, ///< The input is returned together with the result.
  Maps,        ///< Ids of the input have a meaning for the caller.
  Grid,        ///< Points may be rounded to a grid.
  Precision,   ///< The precision of the output is an option.
  ThreadChoice,    ///< The number of threads is an option.
  InputArrays,     ///< The input is a data set, whose arrays have names,
  PointTolerances, ///< one of them with tolerances of points,
  PointLengths,    ///< or with edge lengths at points,
  Labels,          ///< or with labels.
  PassedArrays,    ///< The result is a data set, to which arrays are passed.
  ArrayNames,      ///< The result has arrays whose names are options.
  /// @}

  /// @name Inputs that a run can use, of RunInputs. @{
  Reference,
  LabelMap,
  Log,
  PartOfSurface,
  /// @}

  /// @name Inputs and outputs of the program. @{
  ManyFiles, ///< Several bones.
  OneFile,   ///< One bone, whose files have names.
  OneReference,
  OneLabelMap,
  Volume,        ///< The input is a volume.
  GrayValues,    ///< Its values are gray values.
  IsoSurface,    ///< The surface is that of a gray value.
  Segments,      ///< Segments of a label map are taken.
  LengthUnit,    ///< The input is in a file that does not name its unit.
  WholeInMemory, ///< The whole surface is in memory.
  /// @}
};

using NeedList = std::vector<Need>;

/// What a panel sees of a need: whether a property has, or has not, a value.
struct PanelTerm
{
  std::string Option;
  std::string Value; ///< Choices by their number, switches 0 or 1.
  bool HasValue;     ///< If false, any other value meets it.
};

/// A need that other options meet.
struct NeedInfo
{
  bonedecimate::Need Need;
  bool (*IsMet)(const Options& options);
  std::string Words; ///< "MaximumError or ErrorPreset"
  /// One term of each list holds; empty where a panel cannot see it.
  std::vector<std::vector<PanelTerm>> Panel;
};

/// Every need that other options meet.
const std::vector<NeedInfo>& NeedTable();

/// The row of a need; nullptr if the run decides.
const NeedInfo* FindNeed(Need need);
}

#endif
