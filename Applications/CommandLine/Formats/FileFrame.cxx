// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileFrame.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

namespace bonedecimate
{
namespace
{
constexpr const char* FrameArray = "SPACE";
constexpr std::string_view Key = "SPACE=";

bool IsFrame(std::string_view name)
{
  return name == "RAS" || name == "LPS";
}
}

std::string FrameIn(std::string_view text)
{
  const std::size_t at = text.find(Key);
  const std::string_view name =
    at == std::string_view::npos ? std::string_view() : text.substr(at + Key.size(), 3);
  return IsFrame(name) ? std::string(name) : std::string();
}

std::string FrameOf(vtkPolyData* surface)
{
  auto* const array =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(FrameArray));
  const std::string name =
    array != nullptr && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : "";
  return IsFrame(name) ? name : std::string();
}

void SetFrame(const std::string& frame, vtkPolyData* surface)
{
  if (!frame.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(FrameArray);
    array->InsertNextValue(frame);
    surface->GetFieldData()->AddArray(array);
  }
}

std::string FrameLine(const std::string& frame)
{
  return "3D Slicer output. SPACE=" + frame;
}

vtkSmartPointer<vtkPolyData> TurnedAboutZ(vtkPolyData* surface)
{
  auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->ShallowCopy(surface);
  vtkNew<vtkPoints> points;
  points->DeepCopy(surface->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* p = points->GetPoint(i);
    points->SetPoint(i, -p[0], -p[1], p[2]);
  }
  turned->SetPoints(points);
  return turned;
}
}
