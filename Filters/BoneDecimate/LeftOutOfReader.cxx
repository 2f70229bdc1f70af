// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeftOutOfReader.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cstdlib>
#include <string>

namespace bonedecimate
{
namespace
{
constexpr const char* const ArrayName = "BoneDecimateLeftOut";
constexpr int TextsOfEntry = 4;
}

void AddLeftOutOfReader(const LeftOut& entry, vtkPolyData* surface)
{
  if (entry.Count == 0)
  {
    return;
  }
  vtkFieldData* const fieldData = surface->GetFieldData();
  auto* array = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray(ArrayName));
  vtkNew<vtkStringArray> added; // arrays of other surfaces are shared, and not to be changed
  added->SetName(ArrayName);
  if (array != nullptr)
  {
    added->DeepCopy(array);
  }
  for (const std::string& text :
    { entry.Kind, std::to_string(entry.Count), entry.What, entry.Where })
  {
    added->InsertNextValue(text);
  }
  fieldData->AddArray(added);
}

//------------------------------------------------------------------------------
std::vector<LeftOut> LeftOutOfReader(vtkPolyData* surface)
{
  auto* const array =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(ArrayName));
  std::vector<LeftOut> found;
  const vtkIdType texts = array != nullptr ? array->GetNumberOfValues() : 0;
  for (vtkIdType i = 0; i + TextsOfEntry <= texts; i += TextsOfEntry)
  {
    const auto text = [&](vtkIdType k) { return std::string(array->GetValue(i + k)); };
    found.push_back({ text(0), std::strtoll(text(1).c_str(), nullptr, 10), text(2), text(3) });
  }
  return found;
}

//------------------------------------------------------------------------------
void RemoveLeftOutOfReader(vtkFieldData* fieldData)
{
  fieldData->RemoveArray(ArrayName);
}
}
