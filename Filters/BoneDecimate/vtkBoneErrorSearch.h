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

#include <vector> // for errors

class vtkTable;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneErrorSearch : public vtkPolyDataAlgorithm
{
public:
  static vtkBoneErrorSearch* New();
  vtkTypeMacro(vtkBoneErrorSearch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mode of every run, one of vtkBoneDecimate::Modes but THESIS, which proves nothing. Default BALANCED.
   */
  vtkSetClampMacro(Mode, int, 1, 3);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The number of triangles whose smallest error is looked for; does not count if there are errors. Default 0: none.
   */
  vtkSetClampMacro(TargetNumberOfTriangles, int, 0, VTK_INT_MAX);
  vtkGetMacro(TargetNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * The search ends when the smallest error found and the largest that was tried in vain differ by at most this share,
   * 0.001 to 0.5. Default 0.02.
   */
  vtkSetClampMacro(RelativePrecision, double, 0.001, 0.5);
  vtkGetMacro(RelativePrecision, double);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024. Default 0: one per processor. The answer does not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The largest errors of a curve, mm, above 0; others are left out with a warning. By default there are none.
   */
  void AddError(double millimetres);
  void RemoveAllErrors();
  int GetNumberOfErrors() const { return static_cast<int>(this->Errors.size()); }
  ///@}

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
  ~vtkBoneErrorSearch() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneErrorSearch(const vtkBoneErrorSearch&) = delete;
  void operator=(const vtkBoneErrorSearch&) = delete;

  int Mode = 2;
  int TargetNumberOfTriangles = 0;
  double RelativePrecision = 0.02;
  int NumberOfThreads = 0;
  std::vector<double> Errors;    // mm
  double SmallestError;          // mm
  double ErrorTriedInVain = 0.0; // mm
};

#endif
