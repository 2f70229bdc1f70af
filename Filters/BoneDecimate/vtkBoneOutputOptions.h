// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneOutputOptions
 * @brief   options of the arrays, of the output and of what is left out of the input
 *
 * Written by write_options.py from Documentation/options.md. A value outside its range is an error event, and so are NaN and
 * infinity: the option keeps its value, and updates fail until it is set to a valid one.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneOutputOptions_h
#define vtkBoneOutputOptions_h

#include "vtkBoneGoalOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for texts

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneOutputOptions : public vtkBoneGoalOptions
{
public:
  vtkAbstractTypeMacro(vtkBoneOutputOptions, vtkBoneGoalOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  bool HasOption(const std::string& name) const override;

  ///@{
  /// Return the input on output port 1 with the distance of each point to the result. Default: off.
  void SetMeasureInputDistances(bool value);
  bool GetMeasureInputDistances() const;
  vtkBooleanMacro(MeasureInputDistances, bool);
  ///@}

  ///@{
  /// Precision of the output points. Default: that of the input. One of vtkAlgorithm::DesiredOutputPrecision; default:
  /// DEFAULT_PRECISION.
  void SetOutputPointsPrecision(int value);
  int GetOutputPointsPrecision() const;
  ///@}

  ///@{
  /// Round the output points to whole multiples of this length, for files that hold whole numbers. What is proved, and what the
  /// guards check, are the rounded points. A power of two is exact in single precision. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetOutputPointsGrid(double value);
  double GetOutputPointsGrid() const;
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
  /// Add the arrays OriginalPointIds and OriginalCellIds to the result: the nearest point and cell of the input. Add the array
  /// ResultPointIds to the input on output port 1: the output point into which each input point was merged. Default: off.
  void SetMakeMaps(bool value);
  bool GetMakeMaps() const;
  vtkBooleanMacro(MakeMaps, bool);
  ///@}

  ///@{
  /// Compute point normals from the triangles of the result instead of passing those of the input. Default: off.
  void SetRecomputeNormals(bool value);
  bool GetRecomputeNormals() const;
  vtkBooleanMacro(RecomputeNormals, bool);
  ///@}

  ///@{
  /// Name of the point array with the distance of each output point to the input surface, in mm. Default: "Distance".
  void SetDistanceArrayName(const std::string& value);
  std::string GetDistanceArrayName() const;
  ///@}

  ///@{
  /// Name of the point array with the running error: the largest distance recorded along the collapses into each output point, in
  /// mm. Default: "RunningError".
  void SetRunningErrorArrayName(const std::string& value);
  std::string GetRunningErrorArrayName() const;
  ///@}

  ///@{
  /// Name of the point array with the number of input points that each output point represents. Default: "InputPointCount".
  void SetPointCountArrayName(const std::string& value);
  std::string GetPointCountArrayName() const;
  ///@}

  ///@{
  /// Name of the point array with the distance of each input point to the result, in mm. Default: "DistanceToResult".
  void SetInputDistanceArrayName(const std::string& value);
  std::string GetInputDistanceArrayName() const;
  ///@}

  ///@{
  /// Name of the point array with the proved bound at each output point, in mm: no point of the adjacent triangles is farther from
  /// the input. Needs ProveResult. Default: "ErrorBound".
  void SetErrorBoundArrayName(const std::string& value);
  std::string GetErrorBoundArrayName() const;
  ///@}

  ///@{
  /// Name of the point array with the proved bound at each input point, in mm: no point of the adjacent triangles is farther from
  /// the result. Needs ProveResult and MeasureInputDistances. Default: "ErrorBoundToResult".
  void SetInputErrorBoundArrayName(const std::string& value);
  std::string GetInputErrorBoundArrayName() const;
  ///@}

  ///@{
  /// Remove components whose bounding box has no side of at least this length. The report lists them; errors and proofs refer to
  /// the remaining surface. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetPruneSize(double value);
  double GetPruneSize() const;
  ///@}

  ///@{
  /// Remove components with a smaller area. 0: off. Range: 0 to 1e30 mm2; default: 0.
  void SetPruneArea(double value);
  double GetPruneArea() const;
  ///@}

  ///@{
  /// Remove closed components with a smaller volume; open components stay. 0: off. Range: 0 to 1e30 mm3; default: 0.
  void SetPruneVolume(double value);
  double GetPruneVolume() const;
  ///@}

  ///@{
  /// Remove components with fewer triangles. 0: off. Range: 0 to 2147483647 triangles; default: 0.
  void SetPruneTriangles(int value);
  int GetPruneTriangles() const;
  ///@}

  ///@{
  /// Close tunnels of at most this diameter before anything else: handles of the surface around an opening whose shortest closed
  /// loop of edges is no longer than that of a circle of this diameter. Bone around which such a loop runs is never cut. The report
  /// lists them; errors and proofs refer to the surface with its tunnels closed. 0: off. Range: 0 to 1e30 mm; default: 0.
  void SetTunnelSize(double value);
  double GetTunnelSize() const;
  ///@}

  ///@{
  /// Add diagnostics of the input to the report: kinds, counts and first ids. Default: off.
  void SetDiagnoseInput(bool value);
  bool GetDiagnoseInput() const;
  vtkBooleanMacro(DiagnoseInput, bool);
  ///@}

protected:
  vtkBoneOutputOptions();
  ~vtkBoneOutputOptions() override;

private:
  vtkBoneOutputOptions(const vtkBoneOutputOptions&) = delete;
  void operator=(const vtkBoneOutputOptions&) = delete;
};

#endif
