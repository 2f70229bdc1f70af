// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassedNames.h"

#include "TextureSeams.h"

#include "vtkAbstractArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace bonedecimate
{
namespace
{
/// Whether a run made it: see SurfaceConversion.cxx.
bool IsOfRun(vtkAbstractArray* array)
{
  const char* const unit = array->GetComponentName(0);
  return array->GetNumberOfComponents() == 1 && unit != nullptr &&
    (std::string(unit) == "mm" || std::string(unit) == "points");
}

bool IsRenamed(vtkAbstractArray* array, const std::set<std::string>& own)
{
  return array->GetName() != nullptr && own.count(array->GetName()) > 0 && !IsOfRun(array);
}
}

std::set<std::string> OwnPointArrays(const Options& options)
{
  return { options.DistanceArrayName, options.RunningErrorArrayName, options.PointCountArrayName,
    options.ErrorBoundArrayName };
}

//------------------------------------------------------------------------------
std::set<std::string> OwnInputArrays(const Options& options)
{
  return { options.InputDistanceArrayName, options.InputErrorBoundArrayName };
}

//------------------------------------------------------------------------------
std::string PassedName(
  vtkAbstractArray* array, const std::set<std::string>& own, vtkDataSetAttributes* data)
{
  if (array->GetName() == nullptr)
  {
    return {};
  }
  std::string name = array->GetName();
  if (own.count(name) > 0 && !IsRenamed(array, own))
  {
    return {};
  }
  while (own.count(name) > 0 || (name != array->GetName() && data->HasArray(name.c_str()) != 0))
  {
    name += ".input";
  }
  return name;
}

//------------------------------------------------------------------------------
std::vector<std::string> ArrayWarnings(vtkPolyData* input, const Options& options)
{
  const std::set<std::string> own = OwnPointArrays(options);
  std::vector<std::string> sentences = SeamWarnings(
    options.PassArrays && options.MergePoints ? ArraysWithSeams(input) : std::set<std::string>());
  constexpr std::size_t ofResult = 4;
  constexpr std::size_t ofInput = 2;
  if (own.size() < ofResult || OwnInputArrays(options).size() < ofInput)
  {
    sentences.emplace_back(
      "two arrays that the run makes have the same name, so one of them is missing");
  }
  vtkPointData* data = input->GetPointData();
  for (int i = 0; options.PassArrays && i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (IsRenamed(array, own))
    {
      sentences.push_back("the input's point array '" + std::string(array->GetName()) + "' is '" +
        PassedName(array, own, data) + "' in the result, whose own array has that name");
    }
  }
  return sentences;
}

//------------------------------------------------------------------------------
void KeepUserArrays(vtkPolyData* copy, const Options& options)
{
  const std::set<std::string> own = OwnInputArrays(options);
  vtkPointData* data = copy->GetPointData();
  for (const std::string& name : own)
  {
    vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
    if (array != nullptr && IsRenamed(array, own))
    {
      auto kept = vtkSmartPointer<vtkAbstractArray>::Take(
        vtkAbstractArray::CreateArray(array->GetDataType()));
      kept->DeepCopy(array);
      kept->SetName(PassedName(array, own, data).c_str());
      data->AddArray(kept);
    }
  }
}
}
