// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVBoneDecimate.h"

#include "vtkObjectFactory.h"

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
void vtkPVBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
