// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Regions.h"

#include "Base/Text.h"
#include "CommonOptions.h"

#include "vtkBoneTolerance.h"
#include "vtkBox.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkSphere.h"

#include <optional>

namespace bonedecimate
{
namespace
{
/// False if it is no number, or out of the range.
bool ReadLength(const std::string& text, const NumberRange& range, double& number)
{
  const std::optional<double> value = ParseFinite(text);
  number = value.value_or(0.0);
  return value && IsInRange(range, *value);
}

bool IsOrdered(const std::vector<double>& box)
{
  return box[0] <= box[1] && box[2] <= box[3] && box[4] <= box[5];
}

/// False if it is none of the shapes, or its numbers make no sense.
bool ReadShape(const std::string& text, Region& region)
{
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  const bool areNumbers =
    colon != std::string::npos && ReadNumbers(text.substr(colon + 1), region.Numbers);
  const std::size_t count = region.Numbers.size();
  if (word == "box")
  {
    region.Shape = Region::Box;
    return areNumbers && count == 6 && IsOrdered(region.Numbers);
  }
  if (word == "sphere")
  {
    region.Shape = Region::Sphere;
    return areNumbers && count == 4 && region.Numbers[3] >= 0.0;
  }
  return text == "rest";
}

/// Not positive inside; null for the rest, which has no shape.
vtkSmartPointer<vtkImplicitFunction> FunctionOf(const Region& region)
{
  const std::vector<double>& n = region.Numbers;
  if (region.Shape == Region::Box)
  {
    const auto box = vtkSmartPointer<vtkBox>::New();
    box->SetBounds(n.data());
    return box;
  }
  if (region.Shape == Region::Sphere)
  {
    const auto sphere = vtkSmartPointer<vtkSphere>::New();
    sphere->SetCenter(n[0], n[1], n[2]);
    sphere->SetRadius(n[3]);
    return sphere;
  }
  return nullptr;
}

void Choose(const Region& region, vtkBoneTolerance* filter)
{
  filter->SetChoice(region.Shape == Region::Rest ? vtkBoneTolerance::UNLIMITED
                                                 : vtkBoneTolerance::IMPLICIT_FUNCTION);
  filter->SetInsideTolerance(region.Tolerance);
  filter->SetImplicitFunction(FunctionOf(region));
}

bool HoldsNoPoint(const Region& region, vtkPolyData* surface)
{
  const auto function = FunctionOf(region);
  for (vtkIdType i = 0; function && i < surface->GetNumberOfPoints(); ++i)
  {
    if (function->FunctionValue(surface->GetPoint(i)) <= 0.0)
    {
      return false;
    }
  }
  return function != nullptr;
}
}

bool ReadNumbers(const std::string& text, std::vector<double>& numbers)
{
  bool areNumbers = true;
  for (const std::string& part : SplitAt(text, ','))
  {
    numbers.emplace_back();
    areNumbers = areNumbers && ReadLength(part, CoordinateRange, numbers.back());
  }
  return areNumbers;
}

//------------------------------------------------------------------------------
std::string ReadRegions(const std::string& text, std::vector<Region>& regions)
{
  for (const std::string& part : SplitAt(text, ';'))
  {
    Region region;
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos || !ReadShape(part.substr(0, equals), region) ||
      !ReadLength(part.substr(equals + 1), LengthRange, region.Tolerance))
    {
      return "takes box:x0,x1,y0,y1,z0,z1=MM, sphere:x,y,z,radius=MM or rest=MM in mm, each MM " +
        RangeText(LengthRange) + ", not '" + part + "'";
    }
    region.Text = part;
    regions.push_back(region);
  }
  return {};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithTolerances(
  vtkPolyData* surface, const std::vector<Region>& regions, const std::string& arrayName)
{
  vtkSmartPointer<vtkPolyData> result = surface;
  for (const bool isRest : { false, true })
  {
    for (const Region& region : regions)
    {
      if ((region.Shape == Region::Rest) == isRest)
      {
        vtkNew<vtkBoneTolerance> filter;
        filter->SetToleranceArrayName(arrayName);
        Choose(region, filter);
        filter->SetInputData(result);
        filter->Update();
        result = filter->GetOutput();
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> RegionsWithoutPoints(
  vtkPolyData* surface, const std::vector<Region>& regions)
{
  std::vector<std::string> texts;
  for (const Region& region : regions)
  {
    if (HoldsNoPoint(region, surface))
    {
      texts.push_back(region.Text);
    }
  }
  return texts;
}
}
