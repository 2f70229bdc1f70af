// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPBoneSurfaces.h"

#include "vtkCommunicator.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <vector>

vtkStandardNewMacro(vtkPBoneSurfaces);
vtkCxxSetObjectMacro(vtkPBoneSurfaces, Controller, vtkMultiProcessController);

namespace
{
/// Extent, origin, spacing and direction.
std::vector<double> GeometryOf(vtkImageData* image)
{
  std::vector<double> values(image->GetExtent(), image->GetExtent() + 6);
  values.insert(values.end(), image->GetOrigin(), image->GetOrigin() + 3);
  values.insert(values.end(), image->GetSpacing(), image->GetSpacing() + 3);
  const double* direction = image->GetDirectionMatrix()->GetData();
  values.insert(values.end(), direction, direction + 9);
  return values;
}
}

vtkPBoneSurfaces::vtkPBoneSurfaces()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPBoneSurfaces::~vtkPBoneSurfaces()
{
  this->SetController(nullptr);
}

vtkMultiProcessController* vtkPBoneSurfaces::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
int vtkPBoneSurfaces::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    const std::vector<double> own = GeometryOf(vtkImageData::GetData(inputVector[0]));
    const auto count = static_cast<vtkIdType>(own.size());
    std::vector<double> least = own;
    std::vector<double> most = own;
    this->Controller->AllReduce(own.data(), least.data(), count, vtkCommunicator::MIN_OP);
    this->Controller->AllReduce(own.data(), most.data(), count, vtkCommunicator::MAX_OP);
    if (least != most)
    {
      vtkErrorMacro(
        << "the processes have different images, or pieces of one; each needs the whole "
           "image, so that labels do not end where pieces do");
      return 0;
    }
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkPBoneSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
