// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneGoalOptions
 * @brief   options of where a run ends, and of what is measured and proved
 *
 * Written by write_options.py from Documentation/options.md. A value outside its range is an error event, and so are NaN and
 * infinity: the option keeps its value, and updates fail until it is set to a valid one.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneGoalOptions_h
#define vtkBoneGoalOptions_h

#include "vtkBoneRunOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for texts

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneGoalOptions : public vtkBoneRunOptions
{
public:
  vtkAbstractTypeMacro(vtkBoneGoalOptions, vtkBoneRunOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  bool HasOption(const std::string& name) const override;

  ///@{
  /// Fraction of the triangles to remove. 0: remove none; 1: off. The default is ignored if a number of triangles or a largest
  /// error is set, if every point has a tolerance, or if KeepVoxels is On. Range: 0 to 1; default: 0.9.
  void SetTargetReduction(double value);
  double GetTargetReduction() const;
  ///@}

  ///@{
  /// Largest distance between input and result, proved in both directions for every point of both surfaces, and for open boundaries
  /// curve to curve. 0: off. In Thesis mode the run stops at the first new vertex that is farther from the input: one vertex can
  /// exceed the value, and points between vertices can, too. Range: 0 to 1e30 mm; default: 0.
  void SetMaximumError(double value);
  double GetMaximumError() const;
  ///@}

  /// Values of ErrorPreset.
  enum ErrorPresets
  {
    NO_PRESET = 0,
    QUARTER_VOXEL = 1,
    HALF_VOXEL = 2,
    ONE_VOXEL = 3
  };

  ///@{
  /// Largest error as a fraction of the smallest voxel spacing of the scan (VoxelSize). A quarter is below the resolution of the
  /// scan, a half is about the uncertainty of a surface from the scan, one voxel is for overviews. A smaller MaximumError takes
  /// precedence. One of ErrorPresets; default: NO_PRESET.
  void SetErrorPreset(int value);
  int GetErrorPreset() const;
  ///@}

  ///@{
  /// Smallest voxel spacing of the scan, for ErrorPreset. 0: estimated from the surface, which must be unmodified output of
  /// marching cubes, and reported as an estimate. Range: 0 to 1e30 mm; default: 0.
  void SetVoxelSize(double value);
  double GetVoxelSize() const;
  ///@}

  ///@{
  /// Thesis mode: tolerance w of the normal field deviation. Smaller values raise the cost of flat regions. At 1 an edge between
  /// coplanar triangles costs nothing, whatever its length. Range: 0 to 1; default: 0.95.
  void SetNormalTolerance(double value);
  double GetNormalTolerance() const;
  ///@}

  ///@{
  /// Thesis mode with a number of triangles or a reduction: choose NormalTolerance from the fraction of triangles that remains,
  /// from 0.95 for one half or more to 0 for one tenth or less. The report contains the value. Default: off.
  void SetAutomaticNormalTolerance(bool value);
  bool GetAutomaticNormalTolerance() const;
  vtkBooleanMacro(AutomaticNormalTolerance, bool);
  ///@}

  ///@{
  /// Measure the distances between input and result in both directions. Default: on.
  void SetMeasureDistances(bool value);
  bool GetMeasureDistances() const;
  vtkBooleanMacro(MeasureDistances, bool);
  ///@}

  ///@{
  /// With MaximumError, except in Thesis mode: certify the result as it is written, in both directions and for open boundaries, and
  /// report the proved bounds. Default: on.
  void SetProveResult(bool value);
  bool GetProveResult() const;
  vtkBooleanMacro(ProveResult, bool);
  ///@}

protected:
  vtkBoneGoalOptions();
  ~vtkBoneGoalOptions() override;

private:
  vtkBoneGoalOptions(const vtkBoneGoalOptions&) = delete;
  void operator=(const vtkBoneGoalOptions&) = delete;
};

#endif
