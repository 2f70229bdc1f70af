// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneErrorSearch
 * @brief   the smallest error that can be proved for a number of triangles, and the curve of one
 * against the other
 *
 * Runs several decimations. With TargetNumberOfTriangles it searches for the smallest largest error
 * (mm) that is proved for a result of at most so many triangles. The first run has no largest error
 * and is certified afterwards; the result with the smaller proved error is returned. With errors
 * (AddError()) it runs once for each of them instead: the curve of the number of triangles against
 * the error. Mode must be another than THESIS, which proves nothing. AllowLargeError applies to
 * curves; a search measures its errors.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail until it gets a valid one.
 *
 * Tolerances of points (ToleranceArrayName) and labels of triangles (LabelArrayName) hold in every
 * run. A result is reached only if its tolerances are proved, too.
 *
 * Input port 0: the surface. Input port 1, optional: the reference (SetReferenceData()): the first
 * surface of which the input is a result; all errors are those to it. Input port 2, optional: the
 * label map (SetLabelMapData()).
 *
 * Output port 0: the surface of the best run (of the last error for a curve) with its report; with
 * labels, which it keeps, also with the arrays of the input.
 * Output port 1: a table with a row for each run: MaximumError (mm; 0: none), Triangles,
 * ProvedError (mm, both ways and open boundaries), Reached (whether it is proved and has no more
 * triangles than requested) and Seconds; with a voxel grid ChangedVoxels (with another label than
 * in the input).
 *
 * @sa vtkBoneDecimate vtkBoneSurfaceDistance
 */
#ifndef vtkBoneErrorSearch_h
#define vtkBoneErrorSearch_h

#include "vtkBoneRunOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for sentences
#include <vector> // for errors

class vtkTable;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneErrorSearch : public vtkBoneRunOptions
{
public:
  static vtkBoneErrorSearch* New();
  vtkTypeMacro(vtkBoneErrorSearch, vtkBoneRunOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The search ends when the smallest error found and the largest that was tried in vain differ by
   * at most this ratio, 0.001 to 0.5. Default 0.02.
   */
  void SetRelativePrecision(double ratio);
  vtkGetMacro(RelativePrecision, double);
  ///@}

  ///@{
  /**
   * The largest errors of a curve, mm, above 0 and at most 1e30. By default there are none. After a
   * value outside of that, updates fail until RemoveAllErrors(): a curve never lacks an error
   * silently.
   */
  void AddError(double millimeters);
  void RemoveAllErrors();
  int GetNumberOfErrors() const { return static_cast<int>(this->Errors.size()); }
  ///@}

  /**
   * The first surface, if the input is itself a result: errors are proved against it, tolerances of
   * points against the input. A curve ends with an error if the input is farther from it than one
   * of its errors. Default none.
   */
  void SetReferenceData(vtkPolyData* reference);

  /// Sets the first surface as a connection, to the input port 1. Default none.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  /**
   * The smallest error that is proved, mm; NaN if no run had so few triangles, and after an update
   * that failed.
   */
  double GetSmallestError() const;

  /**
   * The largest error below it with which no run had so few triangles, mm; 0 if there is none, and
   * after an update that failed.
   */
  double GetErrorTriedInVain() const;

  /**
   * The runs, as on output port 1.
   */
  vtkTable* GetTrials();

protected:
  vtkBoneErrorSearch();
  ~vtkBoneErrorSearch() override;

  std::string OptionProblem(
    const bonedecimate::Options& changed, const std::string& name) const override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ForgetReport() override;

private:
  vtkBoneErrorSearch(const vtkBoneErrorSearch&) = delete;
  void operator=(const vtkBoneErrorSearch&) = delete;

  double RelativePrecision = 0.02;
  std::vector<double> Errors;    // mm
  double SmallestError;          // mm
  double ErrorTriedInVain = 0.0; // mm
};

#endif
