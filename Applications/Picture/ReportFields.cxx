// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportFields.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkVariant.h"

namespace bonedecimate
{
namespace
{
const std::string Prefix = "bonedecimate.";

bool IsFilled(vtkAbstractArray* array)
{
  return array && array->GetNumberOfValues() > 0;
}
}

ReportFields::ReportFields(vtkPolyData* result)
  : Fields(result ? result->GetFieldData() : nullptr)
{
}

std::optional<double> ReportFields::Number(const std::string& name) const
{
  vtkDataArray* array = this->Fields ? this->Fields->GetArray((Prefix + name).c_str()) : nullptr;
  return IsFilled(array) ? std::optional<double>(array->GetComponent(0, 0)) : std::nullopt;
}

std::string ReportFields::Text(const std::string& name) const
{
  vtkAbstractArray* array =
    this->Fields ? this->Fields->GetAbstractArray((Prefix + name).c_str()) : nullptr;
  return IsFilled(array) ? array->GetVariantValue(0).ToString() : std::string();
}

std::vector<std::string> ReportFields::NamesBelow(const std::string& beginning) const
{
  std::vector<std::string> names;
  const std::string whole = Prefix + beginning;
  for (int i = 0; this->Fields && i < this->Fields->GetNumberOfArrays(); ++i)
  {
    const char* arrayName = this->Fields->GetArrayName(i);
    const std::string name = arrayName ? arrayName : "";
    if (name.compare(0, whole.size(), whole) == 0)
    {
      names.push_back(name.substr(Prefix.size()));
    }
  }
  return names;
}
}
