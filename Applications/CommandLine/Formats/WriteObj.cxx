// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteObj.h"

#include "FileFrame.h"
#include "TextOutput.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
namespace
{
vtkStringArray* NamesIn(vtkPolyData* surface, const char* name)
{
  return vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(name));
}

vtkDataArray* ArrayOf(vtkDataArray* array, int components)
{
  return array != nullptr && array->GetNumberOfComponents() == components ? array : nullptr;
}

vtkUnsignedCharArray* ColorsOf(vtkPolyData* surface)
{
  return vtkUnsignedCharArray::SafeDownCast(ArrayOf(surface->GetPointData()->GetArray("RGB"), 3));
}

/// The arrays of an OBJ file of several materials: one for each.
std::vector<vtkDataArray*> TexturesOf(vtkPolyData* surface)
{
  vtkPointData* data = surface->GetPointData();
  std::vector<vtkDataArray*> textures;
  const auto add = [&textures](vtkDataArray* array)
  {
    if (array != nullptr && std::find(textures.begin(), textures.end(), array) == textures.end())
    {
      textures.push_back(array);
    }
  };
  add(ArrayOf(data->GetTCoords(), 2));
  vtkStringArray* const names = NamesIn(surface, "MaterialNames");
  for (vtkIdType i = 0; names != nullptr && i < names->GetNumberOfValues(); ++i)
  {
    add(ArrayOf(data->GetArray(names->GetValue(i).c_str()), 2));
  }
  return textures;
}

class ObjWriter
{
public:
  ObjWriter(vtkPolyData* surface, const std::string& path)
    : Surface(surface)
    , Output(path)
    , Textures(TexturesOf(surface))
    , Normals(ArrayOf(surface->GetPointData()->GetNormals(), 3))
    , Colors(ColorsOf(surface))
    , Groups(surface->GetCellData()->GetArray("GroupIds"))
    , Materials(surface->GetCellData()->GetArray("MaterialIds"))
    , MaterialNames(NamesIn(surface, "MaterialNames"))
  {
  }

  void Run()
  {
    const std::string frame = FrameOf(this->Surface);
    this->Output.Add("# " + (frame.empty() ? "written by bonedecimate" : FrameLine(frame)) + "\n");
    vtkStringArray* const libraries = NamesIn(this->Surface, "MaterialLibraries");
    for (vtkIdType i = 0; libraries != nullptr && i < libraries->GetNumberOfValues(); ++i)
    {
      this->Output.Add("mtllib " + libraries->GetValue(i) + "\n");
    }
    this->WritePoints();
    this->WriteCells("p", this->Surface->GetVerts(), false);
    this->WriteCells("l", this->Surface->GetLines(), false);
    this->WriteCells("f", this->Surface->GetPolys(), true);
    this->Output.Close();
  }

private:
  void WriteTuple(const char* keyword, vtkDataArray* array, vtkIdType tuple)
  {
    this->Output.Add(keyword);
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      this->Output.AddNumber(array->GetComponent(tuple, i), array->GetDataType() == VTK_FLOAT);
    }
  }

  void WritePoints()
  {
    vtkDataArray* const points = this->Surface->GetPoints()->GetData();
    const vtkIdType count = points->GetNumberOfTuples();
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->WriteTuple("v", points, i);
      for (int channel = 0; this->Colors != nullptr && channel < 3; ++channel)
      {
        this->Output.AddNumber(this->Colors->GetTypedComponent(i, channel) / 255.0F, true);
      }
      this->Output.Add("\n");
    }
    for (vtkIdType i = 0; !this->Textures.empty() && i < count; ++i)
    {
      this->WriteTuple("vt", this->TextureOf(i), i);
      this->Output.Add("\n");
    }
    for (vtkIdType i = 0; this->Normals != nullptr && i < count; ++i)
    {
      this->WriteTuple("vn", this->Normals, i);
      this->Output.Add("\n");
    }
  }

  /// The first array that has coordinates there; -1 means none.
  vtkDataArray* TextureOf(vtkIdType point) const
  {
    const auto found = std::find_if(this->Textures.begin(), this->Textures.end(),
      [point](vtkDataArray* array)
      { return array->GetComponent(point, 0) != -1.0 || array->GetComponent(point, 1) != -1.0; });
    return found == this->Textures.end() ? nullptr : *found;
  }

  void WriteCells(const char* keyword, vtkCellArray* cells, bool areFaces)
  {
    const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cell->GetCurrentCell(size, corners);
      this->WriteState();
      this->Output.Add(keyword);
      const bool hasTexture = areFaces && !this->Textures.empty() &&
        std::all_of(corners, corners + size, [this](vtkIdType i) { return this->HasTexture(i); });
      for (vtkIdType i = 0; i < size; ++i)
      {
        const std::string number = std::to_string(corners[i] + 1);
        this->Output.Add(" " + number);
        this->Output.Add(hasTexture ? "/" + number : std::string());
        const bool hasNormal = areFaces && this->Normals != nullptr;
        this->Output.Add(hasNormal ? (hasTexture ? "/" : "//") + number : std::string());
      }
      this->Output.Add("\n");
      ++this->Cell;
    }
  }

  bool HasTexture(vtkIdType point) const { return this->TextureOf(point) != nullptr; }

  /// Group and material of the next cell, where they change.
  void WriteState()
  {
    if (this->Groups != nullptr && this->Groups->GetComponent(this->Cell, 0) != this->Group)
    {
      this->Group = this->Groups->GetComponent(this->Cell, 0);
      this->Output.Add("g group" + std::to_string(static_cast<long long>(this->Group)) + "\n");
    }
    if (this->Materials == nullptr || this->MaterialNames == nullptr)
    {
      return;
    }
    const auto material = static_cast<vtkIdType>(this->Materials->GetComponent(this->Cell, 0));
    if (material != this->Material && material >= 0 &&
      material < this->MaterialNames->GetNumberOfValues())
    {
      this->Material = material;
      const std::string name = this->MaterialNames->GetValue(material);
      this->Output.Add("usemtl" + (name == "NO_MATERIAL" ? std::string() : " " + name) + "\n");
    }
  }

  vtkPolyData* Surface;
  TextOutput Output;
  std::vector<vtkDataArray*> Textures;
  vtkDataArray* Normals;
  vtkUnsignedCharArray* Colors;
  vtkDataArray* Groups;
  vtkDataArray* Materials;
  vtkStringArray* MaterialNames;
  vtkIdType Cell = 0;
  double Group = 0.0;
  vtkIdType Material = -1;
};
}

std::set<std::string> ArraysInObj(vtkPolyData* surface)
{
  std::set<std::string> names = { "SPACE", "MaterialLibraries", "GroupIds", "MaterialIds",
    "MaterialNames" };
  std::vector<vtkDataArray*> arrays = TexturesOf(surface);
  arrays.push_back(ArrayOf(surface->GetPointData()->GetNormals(), 3));
  arrays.push_back(ColorsOf(surface));
  for (vtkDataArray* array : arrays)
  {
    names.insert(array != nullptr && array->GetName() != nullptr ? array->GetName() : "");
  }
  return names;
}

//------------------------------------------------------------------------------
void WriteObjFile(vtkPolyData* surface, const std::string& path)
{
  ObjWriter(surface, path).Run();
}
}
