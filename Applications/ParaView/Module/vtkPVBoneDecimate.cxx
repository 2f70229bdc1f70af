// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVBoneDecimate.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkPVBoneDecimate);

//------------------------------------------------------------------------------
void vtkPVBoneDecimate::SetTargetReductionUnlessDefault(double fraction)
{
  this->ForgetTargetReduction();
  if (fraction != this->GetTargetReduction())
  {
    this->SetTargetReduction(fraction);
  }
}

//------------------------------------------------------------------------------
int vtkPVBoneDecimate::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int isDone = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkPolyData* const result = vtkPolyData::GetData(outputVector, 0);
  const std::string distance = this->GetDistanceArrayName();
  if (isDone != 0 && result != nullptr && result->GetPointData()->HasArray(distance.c_str()) != 0)
  {
    result->GetPointData()->SetActiveScalars(distance.c_str());
  }
  return isDone;
}

//------------------------------------------------------------------------------
void vtkPVBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
