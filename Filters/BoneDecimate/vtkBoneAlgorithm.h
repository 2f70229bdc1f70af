// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneAlgorithm
 * @brief   superclass of the filters: rejected values, error codes
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail with the same sentence until it gets a valid one.
 *
 * VTK does not run a filter if an algorithm before it fails, and leaves its output of an earlier
 * update. Figures of that run, such as a proved error, are then gone, and the error code is
 * INPUT_FAILED. Some readers, such as vtkMetaImageReader, do not fail but go on with other data: a
 * program has to observe their vtkCommand::ErrorEvent, and to check that files are complete.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneAlgorithm_h
#define vtkBoneAlgorithm_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for sentences

namespace bonedecimate
{
class RejectedValues;
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBoneAlgorithm, vtkPolyDataAlgorithm);
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  /// What GetErrorCode() returns after an update that failed, beside vtkErrorCode::NoError: the
  /// error event has the reason. From vtkErrorCode::UserError on.
  enum ErrorCodes
  {
    REJECTED_VALUE = 40001, ///< A property has a rejected value (GetRejectedValue()).
    REJECTED_RUN,           ///< The input, or how properties are combined, cannot be used.
    NOT_PROVED,  ///< There is a result, and its certificate does not prove the largest error.
    INPUT_FAILED ///< An algorithm before this one failed, so that there was no run.
  };

  /// VTK's error code or one of ErrorCodes, of the last update.
  unsigned long GetErrorCode() override;

  /// What is wrong with the last value of a property ("NumberOfThreads"), in one sentence; empty if
  /// it was valid.
  std::string GetRejectedValue(const std::string& property) const;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkBoneAlgorithm();
  ~vtkBoneAlgorithm() override;

  /// Reports an error event for each rejected value. @returns Whether there are any.
  bool ReportRejectedValues();

  /// Whether an update after the last run did not get to this filter. What that run found is then
  /// not to be told.
  bool IsOutdated() const;

  bonedecimate::RejectedValues& Rejected() { return *this->Values; }
  const bonedecimate::RejectedValues& Rejected() const { return *this->Values; }

private:
  vtkBoneAlgorithm(const vtkBoneAlgorithm&) = delete;
  void operator=(const vtkBoneAlgorithm&) = delete;

  std::unique_ptr<bonedecimate::RejectedValues> Values;
  vtkMTimeType TimeOfRun = 0; // of the pipeline
};

#endif
