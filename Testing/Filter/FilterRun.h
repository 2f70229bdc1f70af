// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterRun.h
 * @brief A filter with an input, everything it says written down.
 */
#ifndef BoneDecimate_Testing_FilterRun_h
#define BoneDecimate_Testing_FilterRun_h

#include "vtkBoneDecimate.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <functional>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
/**
 *     FilterRun run(Sphere(3));
 *     run->SetTargetReduction(0.5);
 *     vtkPolyData* output = run.Output();
 *
 * Distances are measured only if the test requests it: that takes longer than all the rest. Fails
 * the test if anything of VTK reaches the output window (stderr) past the observers.
 */
class FilterRun
{
public:
  explicit FilterRun(vtkDataObject* input);
  ~FilterRun();
  FilterRun(const FilterRun&) = delete;
  FilterRun& operator=(const FilterRun&) = delete;

  vtkBoneDecimate* operator->() { return this->Filter; }
  vtkBoneDecimate* Get() { return this->Filter; }

  /// Updates; the smaller surface.
  vtkPolyData* Output();
  /// Updates; the input with its distances.
  vtkPolyData* InputCopy();
  /// Updates; number of triangles of the result.
  vtkIdType Triangles() { return this->Output()->GetNumberOfPolys(); }
  /// Updates; a value of the report.
  double Value(const std::string& entry);

  /// Called at every progress, before an abort.
  std::function<void(double)> OnEachProgress = [](double) {};

  /// Aborts at the first progress of at least that much.
  void AbortAt(double fraction) { this->AbortFraction = fraction; }

  /// How often one of the errors or warnings contains the text.
  int Said(const std::string& text) const;
  bool SaidNothing() const { return this->Errors.empty() && this->Warnings.empty(); }
  std::string AllMessages() const;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<double> Progress;
  int Executions = 0;

private:
  void OnEvent(vtkObject* caller, unsigned long event, void* data);
  void OnProgress(double fraction);

  vtkNew<vtkBoneDecimate> Filter;
  double AbortFraction = 2.0;
};
}

#endif
