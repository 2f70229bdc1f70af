// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceConversion.h"

#include "OptionTable.h"
#include "ReportTable.h"
#include "SurfaceArrays.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
namespace
{
const char* const CellIdArrayName = "bonedecimate.cell";

bool HasWrongId(vtkIdType npts, const vtkIdType* ids, vtkIdType numberOfPoints)
{
  return std::any_of(
    ids, ids + npts, [=](vtkIdType id) { return ToIndex(id, numberOfPoints) == None; });
}

/// Calls visit(cell, npts, ids) for every cell of the array; cells are numbered from firstCell.
template <typename Visit>
void VisitCells(vtkCellArray* cells, vtkIdType firstCell, Visit visit)
{
  if (!cells)
  {
    return;
  }
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType npts = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(npts, ids);
    visit(firstCell + iterator->GetCurrentCellId(), npts, ids);
  }
}

void AddTriangle(
  ConvertedSurface& converted, vtkIdType cell, vtkIdType numberOfPoints, const vtkIdType* ids)
{
  converted.Surface.Triangles.push_back({ ToIndex(ids[0], numberOfPoints),
    ToIndex(ids[1], numberOfPoints), ToIndex(ids[2], numberOfPoints) });
  converted.CellOfTriangle.push_back(cell);
}

void AddPoints(vtkPolyData* input, int threads, ConvertedSurface& converted)
{
  const bool any = input->GetNumberOfPoints() > 0; // otherwise there may be no array at all
  converted.IsSingle = any && input->GetPoints()->GetDataType() == VTK_FLOAT;
  if (any)
  {
    converted.Surface.Points = ReadPoints(input->GetPoints(), threads);
  }
}

/// False, and nothing added, if there is anything but triangles.
bool AddPureTriangles(vtkPolyData* input, int threads, ConvertedSurface& converted)
{
  if (input->GetNumberOfStrips() > 0 ||
    !ReadTriangles(
      input->GetPolys(), input->GetNumberOfPoints(), threads, converted.Surface.Triangles))
  {
    return false;
  }
  converted.CellOfTriangle.resize(converted.Surface.Triangles.size());
  std::iota(converted.CellOfTriangle.begin(), converted.CellOfTriangle.end(),
    input->GetNumberOfVerts() + input->GetNumberOfLines());
  return true;
}

/// What there is in polygons and strips, looked at before VTK touches them.
struct CellSurvey
{
  vtkIdType TooShort = 0; // polygons of fewer than three points
  vtkIdType FirstTooShort = -1;
};

/// A cell with a wrong id goes to the core as a triangle, which refuses it with its number; VTK would crash on it.
CellSurvey Survey(vtkPolyData* input, ConvertedSurface& wrongCells)
{
  CellSurvey survey;
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const auto look = [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
  {
    if (npts < 3 && survey.TooShort++ == 0)
    {
      survey.FirstTooShort = cell;
    }
    if (HasWrongId(npts, ids, numberOfPoints))
    {
      wrongCells.Surface.Triangles.push_back({ None, None, None });
      wrongCells.CellOfTriangle.push_back(cell);
    }
  };
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  VisitCells(input->GetPolys(), firstPolygon, look);
  VisitCells(input->GetStrips(), firstPolygon + input->GetNumberOfPolys(), look);
  return survey;
}

void AppendCells(vtkCellArray* from, vtkIdType firstCell, vtkCellArray* to, vtkIdTypeArray* cellIds)
{
  VisitCells(from, firstCell,
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
    {
      if (npts >= 3)
      {
        to->InsertNextCell(npts, ids);
        cellIds->InsertNextValue(cell);
      }
    });
}

/// Polygons and strips through VTK's own triangulation, each triangle with the cell it came from.
void AddTriangulated(vtkPolyData* input, const CellSurvey& survey, ConvertedSurface& converted)
{
  vtkNew<vtkPolyData> cells;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName(CellIdArrayName);
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  AppendCells(input->GetPolys(), firstPolygon, polygons, cellIds);
  AppendCells(input->GetStrips(), firstPolygon + input->GetNumberOfPolys(), strips, cellIds);
  cells->SetPoints(input->GetPoints());
  cells->SetPolys(polygons);
  cells->SetStrips(strips);
  cells->GetCellData()->AddArray(cellIds);
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(cells);
  triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();
  auto* ids =
    vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetAbstractArray(CellIdArrayName));
  vtkIdType different = 0;
  vtkIdType previous = -1;
  VisitCells(triangles->GetPolys(), 0,
    [&](vtkIdType triangle, vtkIdType, const vtkIdType* corners)
    {
      const vtkIdType cell = ids->GetValue(triangle);
      different += cell != previous ? 1 : 0;
      previous = cell;
      AddTriangle(converted, cell, input->GetNumberOfPoints(), corners);
    });
  const vtkIdType lost = cellIds->GetNumberOfTuples() - different + survey.TooShort;
  if (lost > 0)
  {
    converted.Warnings.push_back(std::to_string(lost) +
      " polygons could not be triangulated and were left out" +
      (survey.TooShort > 0 ? ", the first with fewer than three points is cell " +
            std::to_string(survey.FirstTooShort)
                           : std::string()));
  }
}

/// Lines and vertices pass through the filter, except those that would make VTK crash.
void WarnOfWrongLines(vtkPolyData* input, ConvertedSurface& converted)
{
  vtkIdType wrong = 0;
  vtkIdType first = -1;
  const auto look = [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
  {
    if (HasWrongId(npts, ids, input->GetNumberOfPoints()) && wrong++ == 0)
    {
      first = cell;
    }
  };
  VisitCells(input->GetVerts(), 0, look);
  VisitCells(input->GetLines(), input->GetNumberOfVerts(), look);
  if (wrong > 0)
  {
    converted.Warnings.push_back(std::to_string(wrong) +
      " vertices and lines name points that are not there and were left out, the first is cell " +
      std::to_string(first));
  }
}

template <typename Array, typename Values>
void AddPointArray(vtkPolyData* output, const std::string& name, const char* unit,
  const Values& values, vtkIdType tuples, double rest)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfTuples(tuples);
  array->Fill(rest);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  array->SetComponentName(0, unit);
  output->GetPointData()->AddArray(array);
}

/// Copies cells of the input whose points are appended to `points` when they are met first.
vtkSmartPointer<vtkCellArray> PassCells(
  vtkCellArray* cells, vtkPolyData* input, std::vector<vtkIdType>& newId, vtkPoints* points)
{
  auto passed = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> ids;
  VisitCells(cells, 0,
    [&](vtkIdType, vtkIdType npts, const vtkIdType* old)
    {
      if (HasWrongId(npts, old, input->GetNumberOfPoints()))
      {
        return;
      }
      ids.clear();
      for (vtkIdType i = 0; i < npts; ++i)
      {
        vtkIdType& id = newId[static_cast<std::size_t>(old[i])];
        id = id < 0 ? points->InsertNextPoint(input->GetPoint(old[i])) : id;
        ids.push_back(id);
      }
      passed->InsertNextCell(npts, ids.data());
    });
  return passed;
}

vtkSmartPointer<vtkAbstractArray> ReportArray(const ReportEntry& entry)
{
  if (const auto* text = std::get_if<std::string>(&entry.Value))
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->InsertNextValue(*text);
    return array;
  }
  if (const auto* number = std::get_if<double>(&entry.Value))
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->InsertNextValue(*number);
    return array;
  }
  auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
  array->InsertNextValue(std::get<std::int64_t>(entry.Value));
  return array;
}
}

//------------------------------------------------------------------------------
ConvertedSurface ToSurface(vtkPolyData* input, int threads)
{
  ConvertedSurface converted;
  AddPoints(input, threads, converted);
  WarnOfWrongLines(input, converted);
  if (AddPureTriangles(input, threads, converted))
  {
    return converted;
  }
  ConvertedSurface wrongCells;
  const CellSurvey survey = Survey(input, wrongCells);
  if (wrongCells.Surface.Triangles.empty())
  {
    AddTriangulated(input, survey, converted);
  }
  else
  {
    converted.Surface.Triangles = std::move(wrongCells.Surface.Triangles);
    converted.CellOfTriangle = std::move(wrongCells.CellOfTriangle);
  }
  return converted;
}

//------------------------------------------------------------------------------
void NameCells(const ConvertedSurface& converted, Report& report)
{
  CleaningStatistics& found = report.Cleaning;
  for (std::int64_t* triangle : { &found.FirstTriangleOutOfRange, &found.FirstDroppedTriangle })
  {
    *triangle = *triangle < 0 ? -1 : converted.CellOfTriangle[static_cast<std::size_t>(*triangle)];
  }
}

//------------------------------------------------------------------------------
void FillOutput(const Result& result, const Options& options, bool single, vtkPolyData* input,
  vtkPolyData* output)
{
  const int threads = options.NumberOfThreads;
  const vtkSmartPointer<vtkPoints> points = ToPoints(result.Surface.Points, single, threads);
  const vtkSmartPointer<vtkCellArray> triangles = ToCells(result.Surface.Triangles, threads);
  std::vector<vtkIdType> newId(static_cast<std::size_t>(input->GetNumberOfPoints()), -1);
  output->SetVerts(PassCells(input->GetVerts(), input, newId, points));
  output->SetLines(PassCells(input->GetLines(), input, newId, points));
  output->SetPolys(triangles);
  output->SetPoints(points);
  const vtkIdType tuples = points->GetNumberOfPoints();
  if (!result.Distance.empty() || result.Surface.Points.empty())
  {
    AddPointArray<vtkDoubleArray>(
      output, options.DistanceArrayName, "mm", result.Distance, tuples, 0);
    AddPointArray<vtkDoubleArray>(
      output, options.RunningErrorArrayName, "mm", result.RunningError, tuples, 0);
  }
  AddPointArray<vtkIntArray>(
    output, options.PointCountArrayName, "points", result.PointCount, tuples, 1);
  if (!result.ErrorBound.empty())
  {
    AddPointArray<vtkDoubleArray>(
      output, options.ErrorBoundArrayName, "mm", result.ErrorBound, tuples, 0);
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  AddEntries(ReportEntries(result.Report), "bonedecimate.", output->GetFieldData());
}

//------------------------------------------------------------------------------
void AddEntries(
  const std::vector<ReportEntry>& entries, const std::string& prefix, vtkFieldData* fieldData)
{
  for (const ReportEntry& entry : entries)
  {
    vtkSmartPointer<vtkAbstractArray> array = ReportArray(entry);
    array->SetName((prefix + entry.Name).c_str());
    if (!entry.Unit.empty())
    {
      array->SetComponentName(0, entry.Unit.c_str());
    }
    fieldData->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void FillInputCopy(
  const Result& result, const Options& options, vtkPolyData* input, vtkPolyData* output)
{
  output->ShallowCopy(input);
  if (!result.InputDistance.empty())
  {
    AddPointArray<vtkDoubleArray>(output, options.InputDistanceArrayName, "mm",
      result.InputDistance, input->GetNumberOfPoints(), 0);
  }
  if (!result.InputErrorBound.empty())
  {
    AddPointArray<vtkDoubleArray>(output, options.InputErrorBoundArrayName, "mm",
      result.InputErrorBound, input->GetNumberOfPoints(), 0);
  }
}

//------------------------------------------------------------------------------
std::string NamesOfArraysLeftBehind(vtkPolyData* input)
{
  std::string names;
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(input->GetPointData()),
         static_cast<vtkFieldData*>(input->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(unnamed)");
    }
  }
  return names;
}
}
