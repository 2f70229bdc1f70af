// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneAlgorithm
 * @brief   superclass of the filters: rejected values, error codes
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail with the same sentence until it gets a valid one.
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
    NOT_PROVED ///< There is a result, and its certificate does not prove the largest error.
  };

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

  bonedecimate::RejectedValues& Rejected() { return *this->Values; }
  const bonedecimate::RejectedValues& Rejected() const { return *this->Values; }

private:
  vtkBoneAlgorithm(const vtkBoneAlgorithm&) = delete;
  void operator=(const vtkBoneAlgorithm&) = delete;

  std::unique_ptr<bonedecimate::RejectedValues> Values;
};

#endif
