// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileUnit.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace bonedecimate
{
namespace
{
constexpr const char* UnitArray = "bonedecimate.file_unit";
}

void SetFileUnit(const std::string& unit, vtkPolyData* surface)
{
  vtkNew<vtkStringArray> array;
  array->SetName(UnitArray);
  array->InsertNextValue(unit);
  surface->GetFieldData()->AddArray(array);
}

std::string TakeFileUnit(vtkPolyData* surface)
{
  auto* const array =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(UnitArray));
  const std::string unit = array != nullptr ? std::string(array->GetValue(0)) : std::string();
  surface->GetFieldData()->RemoveArray(UnitArray);
  return unit;
}
}
