// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// PLY states its counts: memory is allocated only after the size of the file was compared with
/// them. Not read by VTK, whose reader rounds coordinates to single precision.
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FileFrame.h"
#include "LeftOutOfReader.h"
#include "PlyArrays.h"
#include "PlyElementReader.h"
#include "SurfaceReaders.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <map>

namespace bonedecimate
{
namespace
{
const char* const FaceTexture = "texcoord"; // a list of two numbers for each corner

class PlyReader
{
public:
  explicit PlyReader(const std::string& path)
    : Path(path)
    , Lines(path)
    , Header(ReadPlyHeader(path, this->Lines))
    , Elements(path, this->Header, this->Lines)
  {
  }

  vtkSmartPointer<vtkPolyData> Run(std::vector<std::string>& warnings)
  {
    for (const PlyElement& element : this->Header.Elements)
    {
      if (element.Name == "vertex")
      {
        this->ReadVertices(element);
      }
      else if (element.Name == "face")
      {
        this->ReadFaces(element);
      }
      else if (element.Name == "tristrips")
      {
        this->ReadStrips(element, warnings);
      }
      else
      {
        this->PassOver(element, warnings);
      }
      WarnOfLists(element, warnings);
    }
    if (this->Elements.HasMore())
    {
      Reject(this->Path, "it holds more than its header announces; it is damaged");
    }
    this->Surface->SetPoints(this->Coordinates.MakePoints());
    this->Surface->SetPolys(this->Faces);
    if (this->Strips->GetNumberOfCells() > 0)
    {
      this->Surface->SetStrips(this->Strips);
    }
    this->TakeFaceTexture();
    SetFrame(this->Header.Frame, this->Surface);
    if (this->Header.IsText && !this->Lines.IsEnded())
    {
      warnings.emplace_back("the last line of the input has no end; the file may be cut off");
    }
    return this->Surface;
  }

private:
  [[noreturn]] void RejectElement(const PlyElement& element, std::int64_t number)
  {
    Reject(this->Path,
      "it announces " + std::to_string(element.Count) + " of '" + element.Name +
        "' but ends or breaks in number " + std::to_string(number));
  }

  void ReadElement(const PlyElement& element, std::int64_t number)
  {
    if (!this->Elements.Read(element, this->Values))
    {
      this->RejectElement(element, number);
    }
  }

  void ReadVertices(const PlyElement& element)
  {
    PlyArrays arrays(element, PlyArrays::Kind::Points);
    const std::array<std::size_t, 3> positions = { element.IndexOf("x"), element.IndexOf("y"),
      element.IndexOf("z") };
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      this->ReadElement(element, i);
      for (const std::size_t position : positions)
      {
        this->Coordinates.Add(this->Values.Scalars[position]);
      }
      arrays.Set(i, this->Values.Scalars);
    }
    arrays.AddTo(this->Surface->GetPointData());
  }

  void ReadFaces(const PlyElement& element)
  {
    PlyArrays arrays(element, PlyArrays::Kind::Cells);
    const std::size_t corners = CornersOf(element);
    const std::size_t texture = element.IndexOf(FaceTexture);
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      this->ReadElement(element, i);
      const std::vector<double>& list = this->Values.Lists[corners];
      this->Faces->InsertNextCell(static_cast<int>(list.size()));
      for (const double corner : list)
      {
        if (!(corner >= 0.0 && corner < static_cast<double>(this->Header.Vertices)))
        {
          this->RejectElement(element, i);
        }
        this->Faces->InsertCellPoint(static_cast<vtkIdType>(corner));
      }
      arrays.Set(i, this->Values.Scalars);
      this->KeepTexture(texture, list.size());
    }
    if (std::none_of(this->Header.Elements.begin(), this->Header.Elements.end(),
          [](const PlyElement& other) { return other.Name == "tristrips"; }))
    {
      arrays.AddTo(this->Surface->GetCellData()); // strips have none
    }
  }

  static std::size_t CornersOf(const PlyElement& element)
  {
    const auto isCorners = [](const PlyProperty& property) { return property.IsCorners; };
    return static_cast<std::size_t>(
      std::find_if(element.Properties.begin(), element.Properties.end(), isCorners) -
      element.Properties.begin());
  }

  /// Lists of strips, each of which ends at the number -1 or with its list.
  void ReadStrips(const PlyElement& element, std::vector<std::string>& warnings)
  {
    const std::size_t corners = CornersOf(element);
    std::vector<vtkIdType> strip;
    const auto end = [&]
    {
      if (!strip.empty())
      {
        this->Strips->InsertNextCell(static_cast<vtkIdType>(strip.size()), strip.data());
        strip.clear();
      }
    };
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      this->ReadElement(element, i);
      for (const double corner : this->Values.Lists[corners])
      {
        if (!(corner >= -1.0 && corner < static_cast<double>(this->Header.Vertices)))
        {
          this->RejectElement(element, i);
        }
        if (corner >= 0.0)
        {
          strip.push_back(static_cast<vtkIdType>(corner));
        }
        else
        {
          end();
        }
      }
      end();
    }
    if (element.Properties.size() > 1)
    {
      warnings.emplace_back("the properties of the input's 'tristrips' are not read");
    }
  }

  void PassOver(const PlyElement& element, std::vector<std::string>& warnings)
  {
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      this->ReadElement(element, i);
    }
    const std::string name = "'" + PrintableText(element.Name) + "'";
    AddLeftOutOfReader(
      { "elements", element.Count, (element.Count == 1 ? "element " : "elements ") + name, {} },
      this->Surface);
    if (element.Count > 0)
    {
      warnings.push_back("the " + std::to_string(element.Count) + " elements '" +
        PrintableText(element.Name) + "' of the input are not read");
    }
  }

  static void WarnOfLists(const PlyElement& element, std::vector<std::string>& warnings)
  {
    const bool isRead = element.Name == "vertex" || element.Name == "face";
    for (const PlyProperty& property : element.Properties)
    {
      const bool isTexture = element.Name == "face" && property.Name == FaceTexture;
      if (isRead && property.IsList() && !property.IsCorners && !isTexture)
      {
        warnings.push_back("the lists '" + PrintableText(property.Name) + "' of the input's '" +
          element.Name + "' are not read");
      }
    }
  }

  /// Two numbers for each corner, -1 where a face has others.
  void KeepTexture(std::size_t property, std::size_t corners)
  {
    if (property < this->Values.Lists.size())
    {
      const std::vector<double>& list = this->Values.Lists[property];
      const std::size_t count = 2 * corners;
      for (std::size_t i = 0; i < count; ++i)
      {
        this->FaceTextures.push_back(list.size() == count ? list[i] : -1.0);
      }
    }
  }

  /// Texture coordinates of corners become those of points; a point whose corners differ in them
  /// is there once for each of them.
  void TakeFaceTexture()
  {
    vtkPointData* data = this->Surface->GetPointData();
    if (this->FaceTextures.empty() || data->GetTCoords())
    {
      return;
    }
    vtkPoints* points = this->Surface->GetPoints();
    vtkNew<vtkFloatArray> texture;
    texture->SetName("TCoords");
    texture->SetNumberOfComponents(2);
    texture->SetNumberOfTuples(points->GetNumberOfPoints());
    texture->Fill(-1.0);
    std::vector<bool> isSet(static_cast<std::size_t>(points->GetNumberOfPoints()), false);
    std::map<std::array<double, 3>, vtkIdType> copies; // of a point and its texture coordinates
    vtkDataArray* corners = this->Faces->GetConnectivityArray();
    for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
    {
      const auto point = static_cast<vtkIdType>(corners->GetTuple1(i));
      const auto position = static_cast<std::size_t>(2 * i);
      const double u = this->FaceTextures[position];
      const double v = this->FaceTextures[position + 1];
      vtkIdType own = point;
      if (isSet[static_cast<std::size_t>(point)] && !IsTuple(texture, point, u, v))
      {
        const auto copy = copies.emplace(
          std::array<double, 3>{ static_cast<double>(point), u, v }, points->GetNumberOfPoints());
        own = copy.first->second;
        if (copy.second)
        {
          CopyPoint(points, data, point);
        }
      }
      texture->InsertTuple2(own, u, v);
      isSet[static_cast<std::size_t>(point)] = true;
      corners->SetTuple1(i, static_cast<double>(own));
    }
    data->SetTCoords(texture);
  }

  static bool IsTuple(vtkFloatArray* texture, vtkIdType point, double u, double v)
  {
    return texture->GetComponent(point, 0) == static_cast<double>(static_cast<float>(u)) &&
      texture->GetComponent(point, 1) == static_cast<double>(static_cast<float>(v));
  }

  static void CopyPoint(vtkPoints* points, vtkPointData* data, vtkIdType point)
  {
    points->InsertNextPoint(points->GetPoint(point));
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      data->GetArray(i)->InsertNextTuple(point, data->GetArray(i));
    }
  }

  const std::string& Path;
  LineReader Lines;
  PlyHeader Header;
  PlyElementReader Elements;
  PlyValues Values;
  CoordinateCollector Coordinates;
  vtkNew<vtkCellArray> Faces;
  vtkNew<vtkCellArray> Strips;
  std::vector<double> FaceTextures;
  vtkSmartPointer<vtkPolyData> Surface = vtkSmartPointer<vtkPolyData>::New();
};
}

vtkSmartPointer<vtkPolyData> ReadPlyFile(
  const std::string& path, std::vector<std::string>& warnings)
{
  return PlyReader(path).Run(warnings);
}
}
