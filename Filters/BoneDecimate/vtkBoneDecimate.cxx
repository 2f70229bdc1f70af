// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimate.h"

#include "DecimateInternals.h"
#include "LabelMapOfRun.h"
#include "Partition/Regions/RegionCache.h"
#include "RunState.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBoneDecimate);

vtkBoneDecimate::vtkBoneDecimate()
  : Internal(std::make_unique<Internals>(this))
{
  this->SetNumberOfInputPorts(2);
  this->AddLabelMapPort();
  this->SetNumberOfOutputPorts(2);
}

vtkBoneDecimate::~vtkBoneDecimate() = default;

//------------------------------------------------------------------------------
void vtkBoneDecimate::ForgetTargetReduction()
{
  this->Rejected().Check(this, "TargetReduction", {});
  bonedecimate::Options& options = this->State->Options;
  if (options.TargetReductionIsExplicit)
  {
    options.TargetReduction = bonedecimate::Options().TargetReduction;
    options.TargetReductionIsExplicit = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
/// Results do not depend on it, so the filter is not modified.
void vtkBoneDecimate::SetKeepPrepared(bool keep)
{
  if (keep != this->GetKeepPrepared())
  {
    this->Internal->Prepared = keep ? std::make_shared<bonedecimate::RegionCache>() : nullptr;
  }
}

bool vtkBoneDecimate::GetKeepPrepared() const
{
  return this->Internal->Prepared != nullptr;
}

void vtkBoneDecimate::ReleasePrepared()
{
  if (this->Internal->Prepared)
  {
    this->Internal->Prepared->Release();
  }
}

vtkTypeInt64 vtkBoneDecimate::GetPreparedMemory() const
{
  return this->Internal->Prepared ? static_cast<vtkTypeInt64>(this->Internal->Prepared->Bytes())
                                  : 0;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return this->ReportRejectedValues()
    ? 0
    : this->Internal->Run(vtkPolyData::GetData(inputVector[0]),
        vtkPolyData::GetData(inputVector[1]), this->GetLabelMapRequest(inputVector), outputVector);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KeepPrepared: " << (this->GetKeepPrepared() ? "On" : "Off") << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << " bytes\n";
}
