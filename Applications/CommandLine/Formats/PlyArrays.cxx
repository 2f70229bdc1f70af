// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyArrays.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Colors of real numbers are between 0 and 1.
vtkSmartPointer<vtkDataArray> AsBytes(const vtkSmartPointer<vtkDataArray>& colors)
{
  if (colors->GetDataType() != VTK_FLOAT && colors->GetDataType() != VTK_DOUBLE)
  {
    return colors;
  }
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(colors->GetName());
  bytes->SetNumberOfComponents(colors->GetNumberOfComponents());
  bytes->SetNumberOfTuples(colors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < colors->GetNumberOfComponents(); ++k)
    {
      const double value = std::round(255.0 * colors->GetComponent(i, k));
      bytes->SetComponent(i, k, value > 0.0 ? std::min(value, 255.0) : 0.0);
    }
  }
  return bytes;
}
}

PlyArrays::PlyArrays(const PlyElement& element, Kind kind)
  : Taken(element.Properties.size(), false)
{
  if (kind == Kind::Points)
  {
    for (const char* coordinate : { "x", "y", "z" })
    {
      this->Taken[element.IndexOf(coordinate)] = true;
    }
    this->AddGroup(element, "Normals", vtkDataSetAttributes::NORMALS, { "nx", "ny", "nz" });
    const std::vector<std::string> textures[] = { { "u", "v" }, { "s", "t" },
      { "texture_u", "texture_v" } }; // of VTK, Blender and MeshLab
    for (const std::vector<std::string>& names : textures)
    {
      if (this->AddGroup(element, "TCoords", vtkDataSetAttributes::TCOORDS, names))
      {
        break;
      }
    }
  }
  else
  {
    this->AddGroup(element, "intensity", vtkDataSetAttributes::SCALARS, { "intensity" });
  }
  this->AddColors(element);
  this->AddOthers(element);
}

void PlyArrays::AddColors(const PlyElement& element)
{
  for (const std::string prefix : { "", "diffuse_" })
  {
    const std::vector<std::string> colors = { prefix + "red", prefix + "green", prefix + "blue" };
    std::vector<std::string> withAlpha = colors;
    withAlpha.emplace_back("alpha");
    const std::size_t red = element.IndexOf(colors[0]);
    const std::size_t alpha = element.IndexOf("alpha");
    const std::size_t count = element.Properties.size();
    const bool isAlphaOfThem = red < count && alpha < count &&
      element.Properties[red].Type == element.Properties[alpha].Type;
    if ((isAlphaOfThem &&
          this->AddGroup(element, "RGBA", vtkDataSetAttributes::SCALARS, withAlpha)) ||
      this->AddGroup(element, "RGB", vtkDataSetAttributes::SCALARS, colors))
    {
      return;
    }
  }
}

void PlyArrays::AddOthers(const PlyElement& element)
{
  for (std::size_t i = 0; i < element.Properties.size(); ++i)
  {
    const PlyProperty& property = element.Properties[i];
    if (!this->Taken[i] && !property.IsList() && element.IndexOf(property.Name) == i)
    {
      this->AddGroup(element, property.Name.c_str(), -1, { property.Name });
    }
  }
}

bool PlyArrays::AddGroup(const PlyElement& element, const char* name, int attribute,
  const std::vector<std::string>& properties)
{
  Column column;
  column.Attribute = attribute;
  bool isOneType = true;
  for (const std::string& property : properties)
  {
    const std::size_t index = element.IndexOf(property);
    if (index == element.Properties.size() || element.Properties[index].IsList() ||
      this->Taken[index])
    {
      return false;
    }
    column.Properties.push_back(index);
    isOneType =
      isOneType && element.Properties[index].Type == element.Properties[column.Properties[0]].Type;
  }
  for (const std::size_t index : column.Properties)
  {
    this->Taken[index] = true;
  }
  const int type = isOneType ? element.Properties[column.Properties[0]].Type : VTK_DOUBLE;
  column.Array.TakeReference(vtkDataArray::CreateDataArray(type));
  column.Array->SetName(name);
  column.Array->SetNumberOfComponents(static_cast<int>(column.Properties.size()));
  column.Array->SetNumberOfTuples(element.Count);
  this->Columns.push_back(column);
  return true;
}

void PlyArrays::Set(std::int64_t number, const std::vector<double>& values)
{
  for (const Column& column : this->Columns)
  {
    int component = 0;
    for (const std::size_t property : column.Properties)
    {
      column.Array->SetComponent(number, component, values[property]);
      ++component;
    }
  }
}

void PlyArrays::AddTo(vtkDataSetAttributes* data) const
{
  for (const Column& column : this->Columns)
  {
    const bool isColor = column.Array->GetNumberOfComponents() >= 3 &&
      column.Attribute == vtkDataSetAttributes::SCALARS;
    data->AddArray(isColor ? AsBytes(column.Array) : column.Array);
    if (column.Attribute >= 0)
    {
      data->SetActiveAttribute(column.Array->GetName(), column.Attribute);
    }
  }
}
}
