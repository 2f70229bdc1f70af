// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadSurfaces.cxx
 * @brief Reads surfaces as the program does, many in one process.
 *
 *     standard input:   a path a line
 *     standard output:  a line of JSON for each: points, cells, arrays and warnings, or why the
 *                       file was rejected
 */
#include "ExitCode.h"
#include "Files/SurfaceFiles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

using namespace bonedecimate;

namespace
{
using Json = nlohmann::json;

Json CellsOf(vtkCellArray* cells)
{
  Json result = Json::array();
  const vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, corners);
    result.push_back(std::vector<vtkIdType>(
      corners->GetPointer(0), corners->GetPointer(corners->GetNumberOfIds())));
  }
  return result;
}

Json ValuesOf(vtkAbstractArray* array)
{
  Json values = Json::array();
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const vtkVariant value = array->GetVariantValue(i);
    const int type = array->GetDataType();
    const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
    values.push_back(isReal  ? Json(value.ToDouble())
        : type == VTK_STRING ? Json(value.ToString())
        : type == VTK_UNSIGNED_LONG_LONG || type == VTK_UNSIGNED_LONG
        ? Json(value.ToUnsignedLongLong())
        : Json(value.ToLongLong()));
  }
  return values;
}

Json ArraysOf(vtkFieldData* data)
{
  Json arrays = Json::object();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(i);
    const char* const name = array->GetName();
    arrays[name != nullptr ? name : ""] = { { "type", array->GetDataTypeAsString() },
      { "components", array->GetNumberOfComponents() }, { "values", ValuesOf(array) } };
  }
  return arrays;
}

Json NameOf(vtkDataArray* array)
{
  return array != nullptr && array->GetName() != nullptr ? Json(array->GetName()) : Json();
}

Json SurfaceAsJson(const LoadedSurface& loaded)
{
  vtkPolyData* const surface = loaded.Surface;
  Json points = Json::array();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* const point = surface->GetPoint(i);
    points.push_back({ point[0], point[1], point[2] });
  }
  vtkPointData* const data = surface->GetPointData();
  return { { "points", points }, { "verts", CellsOf(surface->GetVerts()) },
    { "lines", CellsOf(surface->GetLines()) }, { "polys", CellsOf(surface->GetPolys()) },
    { "strips", CellsOf(surface->GetStrips()) }, { "point_data", ArraysOf(data) },
    { "cell_data", ArraysOf(surface->GetCellData()) },
    { "field_data", ArraysOf(surface->GetFieldData()) }, { "normals", NameOf(data->GetNormals()) },
    { "uv", NameOf(data->GetTCoords()) }, { "warnings", loaded.Warnings } };
}

Json Read(const std::string& path)
{
  try
  {
    return SurfaceAsJson(ReadSurface(path));
  }
  catch (const Failure& failure)
  {
    return { { "error", failure.what() } };
  }
}
}

int main()
{
  for (std::string path; std::getline(std::cin, path);)
  {
    std::cout << Read(path).dump(-1, ' ', true, Json::error_handler_t::replace) << std::endl;
  }
  return 0;
}
