// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneRunOptions
 * @brief   options of every filter that runs a decimation
 *
 * Written by write_options.py from Documentation/options.md. A value outside its range is an error event, and so are NaN and
 * infinity: the option keeps its value, and updates fail until it is set to a valid one.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneRunOptions_h
#define vtkBoneRunOptions_h

#include "vtkBoneDecimateAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for texts

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneRunOptions : public vtkBoneDecimateAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBoneRunOptions, vtkBoneDecimateAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  bool HasOption(const std::string& name) const override;

  /// Values of Mode.
  enum Modes
  {
    THESIS = 0,
    FAST = 1,
    BALANCED = 2,
    ACCURATE = 3
  };

  ///@{
  /// Decimation mode. Thesis follows Brandao (2018). Fast orders edges by the change of the normals that a collapse causes, and
  /// nearly preserves the volume. Balanced adds collapses ordered by sampled error, edge flips and vertex moves. Accurate does more
  /// of these. Thesis continues until the number of triangles is reached and, with MaximumError, a new vertex lies beyond it; the
  /// other modes stop at the first criterion that is met. One of Modes; default: BALANCED.
  void SetMode(int value);
  int GetMode() const;
  void SetModeToThesis() { this->SetMode(THESIS); }
  void SetModeToFast() { this->SetMode(FAST); }
  void SetModeToBalanced() { this->SetMode(BALANCED); }
  void SetModeToAccurate() { this->SetMode(ACCURATE); }
  ///@}

  ///@{
  /// Number of triangles to reach. 0: off. Range: 0 to 2147483647 triangles; default: 0.
  void SetTargetNumberOfTriangles(int value);
  int GetTargetNumberOfTriangles() const;
  ///@}

  ///@{
  /// Smooth the surface before the first edit: no point moves by more than this, nor by more than MaximumError and its tolerance
  /// allow. Both steps together keep MaximumError relative to the input. Of the surface of a binary segmentation every voxel keeps
  /// its label in this step. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetSmoothing(double value);
  double GetSmoothing() const;
  ///@}

  ///@{
  /// Smooth the surface of a binary segmentation by its voxel size, if Smoothing is 0: by half of the smallest voxel spacing, or by
  /// a third of a MaximumError or tolerance below that spacing. The voxel grid is found in the surface; any other surface is left
  /// as it is. Default: off.
  void SetAutomaticSmoothing(bool value);
  bool GetAutomaticSmoothing() const;
  vtkBooleanMacro(AutomaticSmoothing, bool);
  ///@}

  ///@{
  /// Smoothing keeps an edge sharp if the normals on its two sides, each averaged over about two voxels, differ by more than this.
  /// 180: off; 45 suits cuts, implants and fractures. Range: 0 to 180 degrees; default: 180.
  void SetFeatureAngle(double value);
  double GetFeatureAngle() const;
  ///@}

  /// Values of KeepVoxels.
  enum KeepVoxelsChoices
  {
    KEEP_VOXELS_OFF = 0,
    KEEP_VOXELS_ON = 1,
    KEEP_VOXELS_AUTO = 2
  };

  ///@{
  /// For surfaces of label maps: reject every edit that lets a voxel center change sides, so that the result, voxelized again,
  /// gives every voxel the label it had. Auto: on without a largest error or with one of at most half a voxel. On alone, without a
  /// target or a largest error, continues until no edit is possible. Needs the voxel grid of the surface. One of KeepVoxelsChoices;
  /// default: KEEP_VOXELS_AUTO.
  void SetKeepVoxels(int value);
  int GetKeepVoxels() const;
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
  /// Accept a largest error above a quarter of the diagonal of the input's bounding box. Without it such a run is rejected, because
  /// the coordinates are probably not in millimeters. Default: off.
  void SetAllowLargeError(bool value);
  bool GetAllowLargeError() const;
  vtkBooleanMacro(AllowLargeError, bool);
  ///@}

  ///@{
  /// With MaximumError, except in Thesis mode: the number of intersecting pairs of triangles does not increase, and gaps between
  /// fragments and between facing walls keep at least half of their width. Default: on.
  void SetIntersectionGuard(bool value);
  bool GetIntersectionGuard() const;
  vtkBooleanMacro(IntersectionGuard, bool);
  ///@}

  ///@{
  /// With a largest error or tolerances, modes Balanced and Accurate: how many rounds of moves and collapses remove triangles after
  /// those of Fast, relative to the rounds of the mode and rounded. More rounds take longer and mostly leave fewer triangles. 0:
  /// none. Range: 0 to 100; default: 1.
  void SetRefinementEffort(double value);
  double GetRefinementEffort() const;
  ///@}

  ///@{
  /// Smallest angle of the triangles of the result, except in Thesis mode: for solvers, meshers and printers. Edits make no
  /// triangle with a smaller one, and triangles of the input that have one are improved by collapses, flips and moves where
  /// everything else that was requested allows it; the report counts those that are left. The number of triangles for a largest
  /// error rises: by a tenth to two fifths at 20 degrees, by two fifths up to double at 30. 0: off. Range: 0 to 40 degrees;
  /// default: 0.
  void SetMinimumAngle(double value);
  double GetMinimumAngle() const;
  ///@}

  ///@{
  /// Length that the edges of the result are to have, except in Thesis mode: for solvers and meshers. Edges longer than 4/3 of it
  /// are split, edges shorter than 4/5 collapsed where everything else that was requested allows it, and flips and moves even out
  /// the triangles. No collapse makes an edge longer than 4/3. There are never more triangles than in the input or than requested,
  /// and levels of detail have no splits; the report counts the edges that are left. Without MinimumAngle no edit makes an angle
  /// below 20 degrees. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetEdgeLength(double value);
  double GetEdgeLength() const;
  ///@}

  ///@{
  /// With EdgeLength: name of a numeric point array of the input with the length that edges are to have at each point, in mm, above
  /// 0. EdgeLength is an upper limit for all. Lengths grow by at most 0.3 mm for each mm along the surface. Empty: none. Default:
  /// none.
  void SetEdgeLengthArrayName(const std::string& value);
  std::string GetEdgeLengthArrayName() const;
  ///@}

  ///@{
  /// With EdgeLength: edges are shorter where the surface is curved, so that an equilateral triangle with its corners on a sphere
  /// of the local curvature lies at most this far below it. Lengths are not shortened below a tenth of EdgeLength, and grow by at
  /// most 0.3 mm for each mm along the surface. The curvature is that of the input, averaged within a quarter of EdgeLength. 0:
  /// off. Range: 0 to 1e30 mm; default: 0.
  void SetChordalError(double value);
  double GetChordalError() const;
  ///@}

  ///@{
  /// Merge points with exactly equal coordinates before the run. If off, triangles without common point ids belong to different
  /// fragments. Default: on.
  void SetMergePoints(bool value);
  bool GetMergePoints() const;
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /// Number of threads. 0: one per processor. The result does not depend on it. Range: 0 to 1024 threads; default: 0.
  void SetNumberOfThreads(int value);
  int GetNumberOfThreads() const;
  ///@}

protected:
  vtkBoneRunOptions();
  ~vtkBoneRunOptions() override;

private:
  vtkBoneRunOptions(const vtkBoneRunOptions&) = delete;
  void operator=(const vtkBoneRunOptions&) = delete;
};

#endif
