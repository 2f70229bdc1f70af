// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyColumns.h"

#include "NamedLabels.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cctype>

namespace bonedecimate
{
namespace
{
/// Arrays of a run have their unit as the name of their component.
bool IsOfRun(vtkDataArray* array)
{
  const char* const unit = array->GetComponentName(0);
  const std::string name = array->GetName() != nullptr ? array->GetName() : "";
  return unit != nullptr && (std::string(unit) == "mm" || std::string(unit) == "points") &&
    array->GetNumberOfComponents() == 1 && !name.empty();
}

bool IsColor(vtkDataArray* array)
{
  const int components = array != nullptr ? array->GetNumberOfComponents() : 0;
  return (components == 3 || components == 4) && array->GetDataType() == VTK_UNSIGNED_CHAR;
}

/// The array of colors: by its name, or the only one there is.
vtkDataArray* ColorsIn(vtkDataSetAttributes* data)
{
  for (const char* name : { ColorArray, "RGBA", "RGB", "Colors", "VertexColor" })
  {
    vtkDataArray* const array = data->GetArray(name);
    if (IsColor(array))
    {
      return array;
    }
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (IsColor(data->GetArray(i)))
    {
      return data->GetArray(i);
    }
  }
  return nullptr;
}

class ColumnList
{
public:
  explicit ColumnList(std::set<std::string> reserved)
    : Names(std::move(reserved))
  {
  }

  void Add(vtkDataArray* array, const std::vector<std::string>& properties)
  {
    if (array != nullptr && PlyTypeName(array->GetDataType()) != nullptr &&
      static_cast<std::size_t>(array->GetNumberOfComponents()) == properties.size())
    {
      this->Columns.push_back({ array, properties });
      this->Names.insert(properties.begin(), properties.end());
    }
  }

  void AddOthers(vtkDataSetAttributes* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = data->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr || IsOfRun(array) || this->Has(array))
      {
        continue;
      }
      const int components = array->GetNumberOfComponents();
      std::vector<std::string> properties;
      properties.reserve(static_cast<std::size_t>(components));
      for (int component = 0; component < components; ++component)
      {
        properties.push_back(
          this->NewName(components == 1 ? std::string(array->GetName())
                                        : array->GetName() + ("_" + std::to_string(component))));
      }
      this->Add(array, properties);
    }
  }

  std::vector<PlyColumn> Columns;

private:
  bool Has(vtkDataArray* array) const
  {
    return std::any_of(this->Columns.begin(), this->Columns.end(),
      [array](const PlyColumn& column) { return column.Array == array; });
  }

  /// Without blanks and letters beyond ASCII, and different from all others.
  std::string NewName(std::string name)
  {
    for (char& c : name)
    {
      const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
      c = isPlain ? c : '_';
    }
    while (name.empty() || this->Names.count(name) > 0)
    {
      name += '_';
    }
    this->Names.insert(name);
    return name;
  }

  std::set<std::string> Names;
};

void AddColors(vtkDataSetAttributes* data, ColumnList& list)
{
  vtkDataArray* const colors = ColorsIn(data);
  if (colors != nullptr)
  {
    list.Add(colors,
      colors->GetNumberOfComponents() == 3
        ? std::vector<std::string>{ "red", "green", "blue" }
        : std::vector<std::string>{ "red", "green", "blue", "alpha" });
  }
}
}

std::vector<PlyColumn> PointColumns(vtkPolyData* surface)
{
  vtkPointData* const data = surface->GetPointData();
  ColumnList list({ "x", "y", "z" });
  list.Add(data->GetTCoords(), { "u", "v" });
  list.Add(data->GetNormals(), { "nx", "ny", "nz" });
  AddColors(data, list);
  list.AddOthers(data);
  return list.Columns;
}

//------------------------------------------------------------------------------
std::vector<PlyColumn> FaceColumns(vtkPolyData* surface)
{
  ColumnList list({ "vertex_indices", "vertex_index", "texcoord" });
  AddColors(surface->GetCellData(), list);
  list.AddOthers(surface->GetCellData());
  return list.Columns;
}

//------------------------------------------------------------------------------
const char* PlyTypeName(int type)
{
  switch (type)
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return "char";
    case VTK_UNSIGNED_CHAR:
      return "uchar";
    case VTK_SHORT:
      return "short";
    case VTK_UNSIGNED_SHORT:
      return "ushort";
    case VTK_INT:
      return "int";
    case VTK_UNSIGNED_INT:
      return "uint";
    case VTK_FLOAT:
      return "float";
    case VTK_DOUBLE:
      return "double";
    default:
      return nullptr;
  }
}

//------------------------------------------------------------------------------
std::set<std::string> ArraysInPly(vtkPolyData* surface)
{
  std::set<std::string> names = { "SPACE" };
  for (const std::vector<PlyColumn>& columns : { PointColumns(surface), FaceColumns(surface) })
  {
    for (const PlyColumn& column : columns)
    {
      names.insert(column.Array->GetName() != nullptr ? column.Array->GetName() : "");
    }
  }
  return names;
}
}
