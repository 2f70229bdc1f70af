// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjCells.h"

#include "FileFrame.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr vtkIdType None = -1;

void AddIndex(std::vector<vtkIdType>& indices, vtkIdType index, vtkIdType corner)
{
  if (index != None && indices.empty())
  {
    indices.assign(static_cast<std::size_t>(corner), None);
  }
  if (index != None || !indices.empty())
  {
    indices.push_back(index);
  }
}

bool IsDefault(const ObjState& state)
{
  return state.Group == 0 && state.Material == -1;
}

/// The arrays of points and cells, and the points themselves where corners need their own.
class SurfaceMaker
{
public:
  explicit SurfaceMaker(ObjContent& content)
    : Content(content)
    , Vertices(content.Vertices.MakePoints())
    , Corners(content.Faces.Vertices->GetConnectivityArray())
  {
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    if (this->MatchesVertices(this->Content.Faces.TextureCoordinates) &&
      this->MatchesVertices(this->Content.Faces.Normals))
    {
      this->TakeVertices();
    }
    else
    {
      this->TakeCorners();
    }
    this->AddGroups();
    this->AddMaterials();
    this->AddColors();
    SetFrame(this->Content.Frame, this->Surface);
    return this->Surface;
  }

private:
  vtkIdType VertexOf(std::size_t corner) const
  {
    return static_cast<vtkIdType>(this->Corners->GetTuple1(static_cast<vtkIdType>(corner)));
  }

  bool MatchesVertices(const std::vector<vtkIdType>& indices) const
  {
    std::size_t corner = 0;
    while (corner < indices.size() &&
      (indices[corner] == None || indices[corner] == this->VertexOf(corner)))
    {
      ++corner;
    }
    return corner == indices.size();
  }

  /// Every vertex is a point; what corners name has the number of their vertex.
  void TakeVertices()
  {
    this->Surface->SetPoints(this->Vertices);
    this->SetCells(
      this->Content.Points.Vertices, this->Content.Lines.Vertices, this->Content.Faces.Vertices);
    const vtkIdType count = this->Vertices->GetNumberOfPoints();
    std::vector<vtkIdType> same(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < same.size(); ++i)
    {
      same[i] = static_cast<vtkIdType>(i);
    }
    if (!this->Content.Faces.TextureCoordinates.empty())
    {
      this->AddTextureCoordinates(same);
    }
    // Where no corner names normals, as many as vertices are theirs in their order.
    const vtkIdType normals = this->Content.Normals->GetNumberOfTuples();
    if (!this->Content.Faces.Normals.empty() || (normals > 0 && normals == count))
    {
      this->AddNormals(same);
    }
  }

  /// Every corner is a point, of lines and single points, too.
  void TakeCorners()
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Vertices->GetDataType());
    const std::vector<vtkIdType>& textures = this->Content.Faces.TextureCoordinates;
    const std::vector<vtkIdType>& normals = this->Content.Faces.Normals;
    const auto faces = this->WithOwnPoints(this->Content.Faces.Vertices, points);
    const auto lines = this->WithOwnPoints(this->Content.Lines.Vertices, points);
    const auto single = this->WithOwnPoints(this->Content.Points.Vertices, points);
    this->Surface->SetPoints(points);
    this->SetCells(single, lines, faces);
    const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
    if (!textures.empty())
    {
      std::vector<vtkIdType> indices = textures;
      indices.resize(count, None);
      this->AddTextureCoordinates(indices);
    }
    if (!normals.empty())
    {
      std::vector<vtkIdType> indices = normals;
      indices.resize(count, None);
      this->AddNormals(indices);
    }
  }

  vtkSmartPointer<vtkCellArray> WithOwnPoints(vtkCellArray* cells, vtkPoints* points)
  {
    auto result = vtkSmartPointer<vtkCellArray>::New();
    const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cell->GetCurrentCell(size, corners);
      result->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        result->InsertCellPoint(points->InsertNextPoint(this->Vertices->GetPoint(corners[i])));
        this->VertexOfPoint.push_back(corners[i]);
      }
    }
    return result;
  }

  void SetCells(vtkCellArray* points, vtkCellArray* lines, vtkCellArray* faces)
  {
    this->Surface->SetVerts(points);
    this->Surface->SetLines(lines);
    this->Surface->SetPolys(faces);
  }

  /// One array for each material: the coordinates that its faces name, -1 at other points.
  void AddTextureCoordinates(const std::vector<vtkIdType>& indexOfPoint)
  {
    const std::vector<std::vector<bool>> used = this->UsedByMaterial();
    for (std::size_t material = 0; material < used.size(); ++material)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(material == 0 ? "TCoords" : this->Content.Materials[material - 1].c_str());
      array->SetNumberOfComponents(2);
      array->SetNumberOfTuples(static_cast<vtkIdType>(indexOfPoint.size()));
      array->Fill(-1.0);
      for (std::size_t i = 0; i < indexOfPoint.size(); ++i)
      {
        const vtkIdType index = indexOfPoint[i];
        if (index >= 0 && index < this->Content.TextureCoordinates->GetNumberOfTuples() &&
          used[material][static_cast<std::size_t>(index)])
        {
          array->SetTuple(static_cast<vtkIdType>(i), index, this->Content.TextureCoordinates);
        }
      }
      const bool isOfFaces =
        std::find(used[material].begin(), used[material].end(), true) != used[material].end();
      if (material > 0 || isOfFaces)
      {
        this->AddPointArray(array);
      }
    }
  }

  void AddPointArray(vtkFloatArray* textureCoordinates)
  {
    vtkPointData* data = this->Surface->GetPointData();
    data->AddArray(textureCoordinates);
    if (!data->GetTCoords())
    {
      data->SetActiveTCoords(textureCoordinates->GetName());
    }
  }

  /// Which texture coordinates the faces without a material name, then those of each material.
  std::vector<std::vector<bool>> UsedByMaterial() const
  {
    const ObjCells& faces = this->Content.Faces;
    const auto count =
      static_cast<std::size_t>(this->Content.TextureCoordinates->GetNumberOfTuples());
    std::vector<std::vector<bool>> used(
      this->Content.Materials.size() + 1, std::vector<bool>(count, false));
    std::size_t corner = 0;
    for (vtkIdType face = 0; face < faces.Vertices->GetNumberOfCells(); ++face)
    {
      const vtkIdType material = StateOf(faces, face).Material;
      for (vtkIdType i = 0; i < faces.Vertices->GetCellSize(face); ++i, ++corner)
      {
        const vtkIdType index = faces.TextureCoordinates[corner];
        if (index != None)
        {
          used[static_cast<std::size_t>(material + 1)][static_cast<std::size_t>(index)] = true;
        }
      }
    }
    return used;
  }

  void AddNormals(const std::vector<vtkIdType>& indexOfPoint)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName("Normals");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(indexOfPoint.size()));
    array->Fill(0.0);
    for (std::size_t i = 0; i < indexOfPoint.size(); ++i)
    {
      if (indexOfPoint[i] >= 0 && indexOfPoint[i] < this->Content.Normals->GetNumberOfTuples())
      {
        array->SetTuple(static_cast<vtkIdType>(i), indexOfPoint[i], this->Content.Normals);
      }
    }
    this->Surface->GetPointData()->SetNormals(array);
  }

  static ObjState StateOf(const ObjCells& cells, vtkIdType cell)
  {
    return cells.States.empty() ? ObjState() : cells.States[static_cast<std::size_t>(cell)];
  }

  /// In the order of VTK's cells: points, lines, faces.
  std::vector<ObjState> AllStates() const
  {
    std::vector<ObjState> states;
    for (const ObjCells* cells :
      { &this->Content.Points, &this->Content.Lines, &this->Content.Faces })
    {
      for (vtkIdType cell = 0; cell < cells->Vertices->GetNumberOfCells(); ++cell)
      {
        states.push_back(StateOf(*cells, cell));
      }
    }
    return states;
  }

  void AddGroups()
  {
    const std::vector<ObjState> states = this->AllStates();
    vtkNew<vtkFloatArray> array;
    array->SetName("GroupIds");
    bool isOne = true;
    for (const ObjState& state : states)
    {
      array->InsertNextValue(static_cast<float>(state.Group));
      isOne = isOne && state.Group == states.front().Group;
    }
    if (!isOne)
    {
      this->Surface->GetCellData()->AddArray(array);
    }
  }

  void AddMaterials()
  {
    this->AddNames("MaterialLibraries", this->Content.MaterialLibraries);
    if (this->Content.Materials.empty())
    {
      return;
    }
    vtkNew<vtkIntArray> array;
    array->SetName("MaterialIds");
    bool hasCellsWithout = false;
    for (const ObjState& state : this->AllStates())
    {
      const bool isWithout = state.Material < 0;
      hasCellsWithout = hasCellsWithout || isWithout;
      array->InsertNextValue(
        isWithout ? static_cast<int>(this->Content.Materials.size()) : state.Material);
    }
    this->Surface->GetCellData()->AddArray(array);
    std::vector<std::string> names = this->Content.Materials;
    if (hasCellsWithout)
    {
      names.emplace_back("NO_MATERIAL");
    }
    this->AddNames("MaterialNames", names);
  }

  /// Colors are between 0 and 1, or between 0 and 255.
  void AddColors()
  {
    const std::vector<float>& colors = this->Content.Colors;
    const auto vertices = static_cast<std::size_t>(this->Vertices->GetNumberOfPoints());
    if (colors.empty() || colors.size() != 3 * vertices)
    {
      return;
    }
    const float most = *std::max_element(colors.begin(), colors.end()) > 1.0F ? 1.0F : 255.0F;
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("RGB");
    array->SetNumberOfComponents(3);
    const vtkIdType points = this->Surface->GetNumberOfPoints();
    array->SetNumberOfTuples(points);
    for (vtkIdType point = 0; point < points; ++point)
    {
      const auto at = static_cast<std::size_t>(point);
      const std::size_t vertex =
        this->VertexOfPoint.empty() ? at : static_cast<std::size_t>(this->VertexOfPoint[at]);
      for (int i = 0; i < 3; ++i)
      {
        const float value = std::round(colors[3 * vertex + static_cast<std::size_t>(i)] * most);
        array->SetTypedComponent(
          point, i, static_cast<unsigned char>(std::clamp(value, 0.0F, 255.0F)));
      }
    }
    this->Surface->GetPointData()->SetScalars(array);
  }

  void AddNames(const char* name, const std::vector<std::string>& values)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& value : values)
    {
      array->InsertNextValue(value);
    }
    if (!values.empty())
    {
      this->Surface->GetFieldData()->AddArray(array);
    }
  }

  ObjContent& Content;
  vtkSmartPointer<vtkPoints> Vertices;
  vtkDataArray* Corners;
  std::vector<vtkIdType> VertexOfPoint; // empty: they are the same
  vtkSmartPointer<vtkPolyData> Surface = vtkSmartPointer<vtkPolyData>::New();
};
}

void ObjCells::Add(const std::vector<ObjCorner>& corners, const ObjState& state)
{
  vtkIdType corner = this->Vertices->GetNumberOfConnectivityIds();
  this->Vertices->InsertNextCell(static_cast<int>(corners.size()));
  for (const ObjCorner& indices : corners)
  {
    this->Vertices->InsertCellPoint(indices[0]);
    AddIndex(this->TextureCoordinates, indices[1], corner);
    AddIndex(this->Normals, indices[2], corner);
    ++corner;
  }
  if (!IsDefault(state) && this->States.empty())
  {
    this->States.resize(static_cast<std::size_t>(this->Vertices->GetNumberOfCells()) - 1);
  }
  if (!IsDefault(state) || !this->States.empty())
  {
    this->States.push_back(state);
  }
}

ObjContent::ObjContent()
{
  this->TextureCoordinates->SetNumberOfComponents(2);
  this->Normals->SetNumberOfComponents(3);
}

vtkSmartPointer<vtkPolyData> SurfaceOf(ObjContent& content)
{
  return SurfaceMaker(content).Make();
}
}
