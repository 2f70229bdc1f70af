// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceConversion.h"

#include "CellVisits.h"
#include "DataTransfer.h"
#include "LeftOutCells.h"
#include "LeftOutOfReader.h"
#include "Options/OptionTable.h"
#include "PassedCells.h"
#include "PassedNames.h"
#include "PolygonCells.h"
#include "Run/Report/ProofSentence.h"
#include "Run/Report/ReportFigures.h"
#include "Run/Report/ReportJson.h"
#include "Run/Report/ReportTable.h"
#include "SurfaceArrays.h"
#include "TextureSeams.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
namespace
{
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

/// Anything but triangles alone.
void AddCells(vtkPolyData* input, ConvertedSurface& converted)
{
  TriangulatedCells cells = TriangulateCells(input, converted.Surface.Points);
  converted.Surface.Triangles = std::move(cells.Triangles);
  converted.CellOfTriangle = std::move(cells.CellOfTriangle);
  converted.LeftOut = FindLeftOut(input, converted.Surface.Points, cells);
  if (cells.LeftOut > 0)
  {
    converted.Warnings.push_back(std::to_string(cells.LeftOut) +
      (cells.LeftOut == 1 ? " polygon of fewer than three different corners was left out"
                          : " polygons of fewer than three different corners were left out") +
      ", the first is cell " + std::to_string(cells.FirstLeftOut));
  }
}

/// Lines and vertices pass through the filter, except those that would make VTK crash.
void WarnOfWrongFeatureCurves(vtkPolyData* input, ConvertedSurface& converted)
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

/// A report of an earlier run does not describe this result, and neither does a certificate of
/// another pair.
void RemoveReport(const ReportArrays& arrays, vtkFieldData* fieldData)
{
  for (int i = fieldData->GetNumberOfArrays(); i-- > 0;)
  {
    const char* name = fieldData->GetArrayName(i);
    const bool isFigure =
      name && std::string(name).compare(0, arrays.Prefix.size(), arrays.Prefix) == 0;
    if (isFigure || (name && (arrays.Json == name || ArraysOfCertificate().Json == name)))
    {
      fieldData->RemoveArray(i);
    }
  }
}

/// What the input knew, carried over. Aborted runs do not know where their points lie.
void AddInputArrays(const Result& result, const ConvertedSurface& converted, const Options& options,
  const PassedIds& passed, vtkPolyData* input, vtkPolyData* output)
{
  const bool isKnown = result.Origins.NearestPoint.size() == result.Surface.Points.size();
  if (options.PassArrays && isKnown)
  {
    const std::set<std::string> leftOut =
      options.MergePoints ? ArraysWithSeams(input) : std::set<std::string>();
    TransferArrays(result, converted, passed, { OwnPointArrays(options), leftOut }, input, output);
  }
  if (options.MakeMaps && isKnown)
  {
    AddMaps(result, converted, passed, output);
  }
  if (options.RecomputeNormals)
  {
    RecomputeNormals(output);
  }
}

void AddOwnArrays(const Result& result, const Options& options, vtkPolyData* output)
{
  const vtkIdType tuples = output->GetNumberOfPoints();
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
}
}

//------------------------------------------------------------------------------
ConvertedSurface ToSurface(vtkPolyData* input, int threads)
{
  ConvertedSurface converted;
  AddPoints(input, threads, converted);
  WarnOfWrongFeatureCurves(input, converted);
  if (AddPureTriangles(input, threads, converted))
  {
    converted.LeftOut = FindLeftOut(input, converted.Surface.Points, {});
    return converted;
  }
  AddCells(input, converted);
  return converted;
}

//------------------------------------------------------------------------------
std::optional<std::vector<double>> ReadNumbers(vtkDataArray* array)
{
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

//------------------------------------------------------------------------------
const ReportArrays& ArraysOfReport()
{
  static const ReportArrays arrays = { "BoneDecimateReport", "bonedecimate.", KeyFigures() };
  return arrays;
}

//------------------------------------------------------------------------------
const ReportArrays& ArraysOfCertificate()
{
  static const ReportArrays arrays = { "BoneDecimateCertificate", "bonedecimate.certificate.",
    CertificateKeyFigures() };
  return arrays;
}

//------------------------------------------------------------------------------
void FillOutput(const Result& result, const ConvertedSurface& converted, const Options& options,
  bool single, vtkPolyData* input, vtkPolyData* output)
{
  const int threads = options.NumberOfThreads;
  const vtkSmartPointer<vtkPoints> points = ToPoints(result.Surface.Points, single, threads);
  PassedCells others(input, points);
  output->SetVerts(others.Pass(input->GetVerts(), 0));
  output->SetLines(others.Pass(input->GetLines(), input->GetNumberOfVerts()));
  output->SetPolys(ToCells(result.Surface.Triangles, threads));
  output->SetPoints(points);
  AddInputArrays(result, converted, options, others.Ids(), input, output);
  AddOwnArrays(result, options, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  RemoveLeftOutOfReader(output->GetFieldData());
  SetReport(BoundToSurface(ReportEntries(result.Report)), ArraysOfReport(), output->GetFieldData());
}

//------------------------------------------------------------------------------
void SetReport(
  const std::vector<ReportEntry>& entries, const ReportArrays& arrays, vtkFieldData* fieldData)
{
  RemoveReport(arrays, fieldData);
  const auto json = ReportArray({ "", "", ReportJson(entries) });
  json->SetName(arrays.Json.c_str());
  fieldData->AddArray(json);
  for (const ReportEntry& entry : entries)
  {
    const std::vector<std::string>& names = arrays.KeyFigures;
    if (std::find(names.begin(), names.end(), entry.Name) != names.end())
    {
      const vtkSmartPointer<vtkAbstractArray> array = ReportArray(entry);
      array->SetName((arrays.Prefix + entry.Name).c_str());
      if (!entry.Unit.empty())
      {
        array->SetComponentName(0, entry.Unit.c_str());
      }
      fieldData->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
void FillInputCopy(
  const Result& result, const Options& options, vtkPolyData* input, vtkPolyData* output)
{
  output->ShallowCopy(input);
  KeepUserArrays(output, options);
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
  if (options.MapsInput() && !result.Origins.OutputPoint.empty())
  {
    AddInputMap(result, output);
  }
}

//------------------------------------------------------------------------------
bool NeedsOrigins(vtkPolyData* input, const Options& options)
{
  const bool hasArrays =
    input->GetPointData()->GetNumberOfArrays() > 0 || input->GetCellData()->GetNumberOfArrays() > 0;
  return options.MapsInput() || (options.PassArrays && hasArrays);
}
}
