// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneAlgorithm.h"

#include "RejectedValues.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace
{
/// Also of field data, which VTK passes from the input: it may prove something of another surface.
void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* const output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}
}

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
/// The time of the pipeline is that of the last update that was begun, by this filter or one after
/// it.
bool vtkBoneAlgorithm::IsOutdated() const
{
  auto* const filter = const_cast<vtkBoneAlgorithm*>(this);
  auto* const pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
  return pipeline != nullptr && pipeline->GetPipelineMTime() > this->TimeOfRun;
}

unsigned long vtkBoneAlgorithm::GetErrorCode()
{
  constexpr unsigned long inputFailed = INPUT_FAILED;
  return this->IsOutdated() ? inputFailed : this->Superclass::GetErrorCode();
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
    this->TimeOfRun =
      vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive())->GetPipelineMTime();
  }
  const vtkTypeBool isDone = this->Superclass::ProcessRequest(request, inputs, outputs);
  if (isRun && isDone == 0)
  {
    this->ErrorCode = this->Values->AreThere() ? REJECTED_VALUE : REJECTED_RUN;
    EmptyOutputs(outputs);
  }
  return isDone;
}
