// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelFields.h"

namespace bonedecimate::volume
{
bool HasLabelFields(vtkImageData* image)
{
  return image->GetFieldData()->HasArray(LabelNumberNames[0]) != 0;
}

void CopyLabelFields(vtkFieldData* from, vtkFieldData* to)
{
  for (const char* name : { LabelNumberNames[0], LabelNumberNames[1], LabelNamesName })
  {
    vtkAbstractArray* const array = from->GetAbstractArray(name);
    if (array)
    {
      to->AddArray(array);
    }
  }
}
}
