// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneSmoothOptions
 * @brief   options of a run that smooths and removes no triangles
 *
 * Written by write_options.py from Documentation/options.md. A value outside its range is an error event, and so are NaN and
 * infinity: the option keeps its value, and updates fail until it is set to a valid one.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneSmoothOptions_h
#define vtkBoneSmoothOptions_h

#include "vtkBoneDecimateAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for texts

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneSmoothOptions : public vtkBoneDecimateAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBoneSmoothOptions, vtkBoneDecimateAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  bool HasOption(const std::string& name) const override;

  ///@{
  /// Smooth the surface before the first edit: no point moves by more than this, nor by more than MaximumError and its tolerance
  /// allow. Both steps together keep MaximumError relative to the input. Of the surface of a binary segmentation every voxel keeps
  /// its label in this step. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetSmoothing(double value);
  double GetSmoothing() const;
  ///@}

  ///@{
  /// Smoothing keeps an edge sharp if the normals on its two sides, each averaged over about two voxels, differ by more than this.
  /// 180: off; 45 suits cuts, implants and fractures. Range: 0 to 180 degrees; default: 180.
  void SetFeatureAngle(double value);
  double GetFeatureAngle() const;
  ///@}

  ///@{
  /// Largest distance between input and result, proved in both directions for every point of both surfaces, and for open boundaries
  /// curve to curve. 0: off. In Thesis mode the run stops at the first new vertex that is farther from the input: one vertex can
  /// exceed the value, and points between vertices can, too. Range: 0 to 1e30 mm; default: 0.
  void SetMaximumError(double value);
  double GetMaximumError() const;
  ///@}

  ///@{
  /// Name of a numeric point array of the input with the largest error at each point, in mm. 0 keeps the point and its triangles
  /// unchanged. A negative value sets no limit. A positive value is interpolated linearly on each triangle and proved like
  /// MaximumError, which is an upper limit for all. Thesis mode accepts only 0 and negative values. Empty: none. Default: none.
  void SetToleranceArrayName(const std::string& value);
  std::string GetToleranceArrayName() const;
  ///@}

  ///@{
  /// Name of an integer cell or point array with the bone, fragment or segment of each triangle. A cell array takes precedence; of
  /// a point array the majority of the three corners counts. Curves between different labels are simplified only along themselves,
  /// and every triangle keeps its label. Empty: none. Default: none.
  void SetLabelArrayName(const std::string& value);
  std::string GetLabelArrayName() const;
  ///@}

  ///@{
  /// Merge points with exactly equal coordinates before the run. If off, triangles without common point ids belong to different
  /// fragments. Default: on.
  void SetMergePoints(bool value);
  bool GetMergePoints() const;
  vtkBooleanMacro(MergePoints, bool);
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

  ///@{
  /// Pass the point and cell arrays of the input to the result. Floating-point point data is interpolated at the nearest position
  /// on the input. Everything else is copied from the nearest point, or from the cell nearest to the centroid of the triangle.
  /// Default: on.
  void SetPassArrays(bool value);
  bool GetPassArrays() const;
  vtkBooleanMacro(PassArrays, bool);
  ///@}

  ///@{
  /// Precision of the output points. Default: that of the input. One of vtkAlgorithm::DesiredOutputPrecision; default:
  /// DEFAULT_PRECISION.
  void SetOutputPointsPrecision(int value);
  int GetOutputPointsPrecision() const;
  ///@}

  ///@{
  /// Compute point normals from the triangles of the result instead of passing those of the input. Default: off.
  void SetRecomputeNormals(bool value);
  bool GetRecomputeNormals() const;
  vtkBooleanMacro(RecomputeNormals, bool);
  ///@}

  ///@{
  /// Accept a largest error above a quarter of the diagonal of the input's bounding box. Without it such a run is rejected, because
  /// the coordinates are probably not in millimeters. Default: off.
  void SetAllowLargeError(bool value);
  bool GetAllowLargeError() const;
  vtkBooleanMacro(AllowLargeError, bool);
  ///@}

  ///@{
  /// Number of threads. 0: one per processor. The result does not depend on it. Range: 0 to 1024 threads; default: 0.
  void SetNumberOfThreads(int value);
  int GetNumberOfThreads() const;
  ///@}

protected:
  vtkBoneSmoothOptions();
  ~vtkBoneSmoothOptions() override;

private:
  vtkBoneSmoothOptions(const vtkBoneSmoothOptions&) = delete;
  void operator=(const vtkBoneSmoothOptions&) = delete;
};

#endif
