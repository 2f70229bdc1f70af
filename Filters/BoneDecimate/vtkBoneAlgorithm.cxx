// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneAlgorithm.h"

#include "RejectedValues.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"

vtkBoneAlgorithm::vtkBoneAlgorithm()
  : Values(std::make_unique<bonedecimate::RejectedValues>())
{
}

vtkBoneAlgorithm::~vtkBoneAlgorithm() = default;

//------------------------------------------------------------------------------
std::string vtkBoneAlgorithm::GetRejectedValue(const std::string& property) const
{
  return this->Values->Of(property);
}

vtkMTimeType vtkBoneAlgorithm::GetMTime()
{
  return this->Values->MTime(this->Superclass::GetMTime());
}

bool vtkBoneAlgorithm::ReportRejectedValues()
{
  return this->Values->Report(this);
}

//------------------------------------------------------------------------------
/// The error code is not a property: setting it does not modify the filter.
vtkTypeBool vtkBoneAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool isRun = request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) != 0;
  if (isRun)
  {
    this->ErrorCode = 0;
  }
  const vtkTypeBool isDone = this->Superclass::ProcessRequest(request, inputs, outputs);
  if (isRun && isDone == 0)
  {
    this->ErrorCode = this->Values->AreThere() ? REJECTED_VALUE : REJECTED_RUN;
  }
  return isDone;
}
