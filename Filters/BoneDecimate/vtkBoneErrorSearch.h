// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneErrorSearch
 * @brief   the smallest error that can be proved for a number of triangles, and the curve of one against the other
 *
 * Runs vtkBoneDecimate's engine again and again. With TargetNumberOfTriangles it looks for the smallest MaximumError (mm)
 * with which so few triangles can be proved, beginning with the run that has no largest error and is certified afterwards;
 * the better of both ways is the answer. With errors of its own (AddError()) it runs each of them once: the curve.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and updates fail until it gets a
 * valid one.
 *
 * Output port 0: the surface of the best run (of the last error for a curve) with its report.
 * Output port 1: a table with a row for each run: MaximumError (mm; 0: none was asked for), Triangles, ProvedError (mm, both
 * ways and open borders), Reached (whether it is proved and no larger than asked for) and Seconds.
 *
 * @sa vtkBoneDecimate vtkBoneSurfaceDistance
 */
#ifndef vtkBoneErrorSearch_h
#define vtkBoneErrorSearch_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for sentences
#include <vector> // for errors

class vtkTable;

namespace bonedecimate
{
class RejectedValues;
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneErrorSearch : public vtkPolyDataAlgorithm
{
public:
  static vtkBoneErrorSearch* New();
  vtkTypeMacro(vtkBoneErrorSearch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  ///@{
  /**
   * The mode of every run, one of vtkBoneDecimate::Modes but THESIS, which proves nothing. Default BALANCED.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The number of triangles whose smallest error is looked for; does not count if there are errors. 0 to 2147483647; default 0: none.
   */
  void SetTargetNumberOfTriangles(int triangles);
  vtkGetMacro(TargetNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * The search ends when the smallest error found and the largest that was tried in vain differ by at most this share,
   * 0.001 to 0.5. Default 0.02.
   */
  void SetRelativePrecision(double share);
  vtkGetMacro(RelativePrecision, double);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024. Default 0: one per processor. The answer does not depend on it.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The largest errors of a curve, mm, above 0 and at most 1e30. By default there are none. After a value outside of that, updates
   * fail until RemoveAllErrors(): a curve never lacks an error silently.
   */
  void AddError(double millimetres);
  void RemoveAllErrors();
  int GetNumberOfErrors() const { return static_cast<int>(this->Errors.size()); }
  ///@}

  ///@{
  /**
   * Run a curve although one of its errors is more than a quarter of the diagonal of the input's bounding box, off by default: an
   * error.
   */
  vtkSetMacro(AllowLargeError, bool);
  vtkGetMacro(AllowLargeError, bool);
  vtkBooleanMacro(AllowLargeError, bool);
  ///@}

  /**
   * What is wrong with the last value of a property ("Mode"), or with an error of the curve ("Error"), in one sentence; empty if
   * nothing is.
   */
  std::string GetRejectedValue(const std::string& property) const;

  /**
   * The smallest error that is proved, mm; not a number if no run was as small as asked for.
   */
  double GetSmallestError() const { return this->SmallestError; }

  /**
   * The largest error below it for which no run was as small as asked for, mm; 0 if none failed.
   */
  double GetErrorTriedInVain() const { return this->ErrorTriedInVain; }

  /**
   * The runs, as on output port 1.
   */
  vtkTable* GetTrials();

protected:
  vtkBoneErrorSearch();
  ~vtkBoneErrorSearch() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneErrorSearch(const vtkBoneErrorSearch&) = delete;
  void operator=(const vtkBoneErrorSearch&) = delete;

  int Mode = 2;
  int TargetNumberOfTriangles = 0;
  double RelativePrecision = 0.02;
  bool AllowLargeError = false;
  int NumberOfThreads = 0;
  std::vector<double> Errors;    // mm
  double SmallestError;          // mm
  double ErrorTriedInVain = 0.0; // mm
  std::unique_ptr<bonedecimate::RejectedValues> Rejected;
};

#endif
