// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteObj.h"

#include "FileFrame.h"
#include "TextOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>
#include <utility>
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
  /// Positions are those of any reader only if their decimals are those of double precision.
  void WriteTuple(
    const char* keyword, vtkDataArray* array, vtkIdType tuple, bool isPosition = false)
  {
    this->Output.Add(keyword);
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      const bool isSingle = !isPosition && array->GetDataType() == VTK_FLOAT;
      this->Output.AddNumber(array->GetComponent(tuple, i), isSingle);
    }
  }

  void WritePoints()
  {
    vtkDataArray* const points = this->Surface->GetPoints()->GetData();
    const vtkIdType count = points->GetNumberOfTuples();
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->WriteTuple("v", points, i, true);
      for (int channel = 0; this->Colors != nullptr && channel < 3; ++channel)
      {
        this->Output.AddNumber(this->Colors->GetTypedComponent(i, channel) / 255.0F, true);
      }
      this->Output.Add("\n");
    }
    for (vtkIdType i = 0; !this->Textures.empty() && i < count; ++i)
    {
      if (vtkDataArray* const texture = this->TextureOf(i); texture != nullptr)
      {
        this->WriteTuple("vt", texture, i);
        this->Output.Add("\n");
      }
      else
      {
        this->Output.Add("vt -1 -1\n"); // keeps the numbers of the others
      }
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

  /// Cells of one group and one material come together, otherwise in their order.
  void WriteCells(const char* keyword, vtkCellArray* cells, bool areFaces)
  {
    const vtkIdType count = cells->GetNumberOfCells();
    std::vector<vtkIdType> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    if (this->Groups != nullptr || this->Materials != nullptr)
    {
      std::stable_sort(order.begin(), order.end(),
        [this](vtkIdType a, vtkIdType b)
        { return this->StateOf(this->First + a) < this->StateOf(this->First + b); });
    }
    vtkNew<vtkIdList> corners;
    for (const vtkIdType cell : order)
    {
      this->WriteState(this->First + cell);
      cells->GetCellAtId(cell, corners);
      this->WriteCell(keyword, corners, areFaces);
    }
    this->First += count;
  }

  void WriteCell(const char* keyword, vtkIdList* corners, bool isFace)
  {
    this->Output.Add(keyword);
    const bool hasTexture = isFace && !this->Textures.empty() &&
      std::all_of(
        corners->begin(), corners->end(), [this](vtkIdType i) { return this->HasTexture(i); });
    const bool hasNormal = isFace && this->Normals != nullptr;
    for (const vtkIdType corner : *corners)
    {
      const std::string number = std::to_string(corner + 1);
      this->Output.Add(" " + number);
      this->Output.Add(hasTexture ? "/" + number : std::string());
      this->Output.Add(hasNormal ? (hasTexture ? "/" : "//") + number : std::string());
    }
    this->Output.Add("\n");
  }

  std::pair<double, double> StateOf(vtkIdType cell) const
  {
    return { this->Groups != nullptr ? this->Groups->GetComponent(cell, 0) : 0.0,
      this->Materials != nullptr ? this->Materials->GetComponent(cell, 0) : -1.0 };
  }

  bool HasTexture(vtkIdType point) const { return this->TextureOf(point) != nullptr; }

  /// Group and material of a cell, where they change.
  void WriteState(vtkIdType cell)
  {
    const auto [group, given] = this->StateOf(cell);
    if (group != this->Group)
    {
      this->Group = group;
      this->Output.Add("g group" + std::to_string(static_cast<long long>(group)) + "\n");
    }
    const auto material = static_cast<vtkIdType>(given);
    if (material != this->Material && material >= 0 && this->MaterialNames != nullptr &&
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
  vtkIdType First = 0; // cell of the kind that is written
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
