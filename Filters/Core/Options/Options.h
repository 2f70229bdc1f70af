// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Options.h
 * @brief The options of a run. OptionRows.def has name, default, range, unit and meaning of each.
 */
#ifndef BoneDecimate_Core_Options_Options_h
#define BoneDecimate_Core_Options_Options_h

#include "Modes.h"

#include <algorithm>
#include <array>
#include <string>

namespace bonedecimate
{
/// The values are those of vtkAlgorithm::DesiredOutputPrecision.
enum class PointsPrecision : int
{
  Single = 0,
  Double = 1,
  Default = 2 ///< That of the input points.
};

/// A largest error as a fraction of the voxel size.
enum class ErrorPreset : int
{
  NoPreset = 0,
  QuarterVoxel = 1,
  HalfVoxel = 2,
  OneVoxel = 3
};

/// Whether edits are rejected that let a voxel center change sides.
enum class KeepVoxels : int
{
  Off = 0,
  On = 1,
  /// If the grid is known, and there is no largest error or one of at most half a voxel.
  Automatic = 2
};

/// A field for each row of OptionRows.def, which has its default, meaning, range and unit.
struct Options
{
#define BONEDECIMATE_OPTION(Type, Name, Default, Traits, Sentence) Type Name = Default;
#include "OptionRows.def"
#undef BONEDECIMATE_OPTION

  /// Must be set together with TargetReduction. While it is false, the default reduction is ignored
  /// if a number of triangles or a largest error is given.
  bool TargetReductionIsExplicit = false;

  /// Whether the surface is smoothed before the first edit, if there is something to smooth.
  bool Smooths() const
  {
    return this->Smoothing > 0.0 || this->AutomaticSmoothing;
  }

  /// Degrees, 0 in a mode that does not limit angles.
  double EffectiveMinimumAngle() const
  {
    return FindMode(this->Mode).LimitsShapes() ? this->MinimumAngle : 0.0;
  }

  /// mm, 0 in a mode that does not limit edges.
  double EffectiveEdgeLength() const
  {
    return FindMode(this->Mode).LimitsShapes() ? this->EdgeLength : 0.0;
  }

  /// Whether points are written in single precision.
  /// @param inputIsSingle Precision of the input's points.
  bool WritesSingle(bool inputIsSingle) const
  {
    return this->OutputPointsPrecision == PointsPrecision::Single ||
      (this->OutputPointsPrecision == PointsPrecision::Default && inputIsSingle);
  }

  /// Voxels, of ErrorPreset; 0: no preset.
  double VoxelsOfPreset() const
  {
    constexpr std::array<double, 4> voxels = { 0.0, 0.25, 0.5, 1.0 };
    return voxels[static_cast<std::size_t>(this->ErrorPreset)];
  }

  /// mm, the smaller one of MaximumError and the error of the preset, of those that are set; 0:
  /// none.
  /// @param voxelSize mm
  double MaxError(double voxelSize) const
  {
    const double ofPreset = this->VoxelsOfPreset() * voxelSize;
    return this->MaximumError > 0.0 && ofPreset > 0.0 ? std::min(this->MaximumError, ofPreset)
                                                      : std::max(this->MaximumError, ofPreset);
  }

  /// Whether TargetReduction ends the run: its default does not if anything else would.
  /// @param isLimited Whether an error or tolerances end it.
  bool EndsAtReduction(bool isLimited) const
  {
    const bool anyOther = isLimited || this->TargetNumberOfTriangles > 0 ||
      this->MaximumError > 0.0 || this->KeepVoxels == bonedecimate::KeepVoxels::On ||
      this->EffectiveEdgeLength() > 0.0;
    return this->TargetReduction < 1.0 && (this->TargetReductionIsExplicit || !anyOther);
  }

  /// Whether no triangle is to be removed.
  bool KeepsAllTriangles() const
  {
    return this->TargetNumberOfTriangles == 0 && this->TargetReductionIsExplicit &&
      this->TargetReduction == 0.0;
  }

  /// Whether small components are removed: an option is used that needs whole components.
  bool Prunes() const;

  /// The same options without those that remove components.
  Options WithoutPruning() const;

  /// Whether the copy of the input says which output point each of its points became.
  bool MapsInput() const
  {
    return this->MakeMaps || (this->Prunes() && this->MeasureInputDistances);
  }

  /// Whether the mode proves every edit that a largest error or a tolerance limits.
  bool ProvesError() const
  {
    return FindMode(this->Mode).ProvesError();
  }

  /// Whether MaximumError bounds the distance of every point of both surfaces.
  bool BoundsError() const
  {
    return this->ProvesError() &&
      (this->MaximumError > 0.0 || this->ErrorPreset != bonedecimate::ErrorPreset::NoPreset);
  }
};
}

#endif
