// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileRounding.h"

#include "ExitCode.h"
#include "Figures/BoundText.h"
#include "FileNames.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "Geometry/Surface.h"
#include "PointPosition.h"
#include "ReportFields.h"
#include "ReportOfSurface.h"
#include "Run/Input/VoxelSize.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;
using Position = std::array<double, 3>;

/// What an entry of the proof becomes.
double Widened(const std::string& name, double value, double move, double error)
{
  if (name == "upper")
  {
    return value + move;
  }
  if (name == "lower")
  {
    return std::max(0.0, value - move);
  }
  return error > 0.0 && name == "tolerance" ? error : value;
}

/// Widens all entries below one.
void Widen(Json& json, double move, double error)
{
  for (auto& item : json.items())
  {
    if (item.value().is_object())
    {
      Widen(item.value(), move, error);
    }
    else if (item.value().is_number_float())
    {
      item.value() = Widened(item.key(), item.value().get<double>(), move, error);
    }
  }
}

/// How far the farthest point of a result, mm, lies from itself in the file, mm.
double LargestMove(vtkPolyData* result, vtkPolyData* inFile, const LengthUnit& unit)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    const Position from = PositionOf(result, i);
    const Position to = PositionOf(inFile, i);
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double step = unit.ToMillimeters(to[axis]) - from[axis];
      square += step * step;
    }
    largest = std::max(largest, square);
  }
  return std::sqrt(largest) * (1.0 + 8.0 * std::numeric_limits<double>::epsilon());
}

/// A copy whose proved bounds in the field data hold for the file. @param error What is kept then,
/// mm; 0: as it is.
vtkSmartPointer<vtkPolyData> WithWidenedProof(vtkPolyData* result, double move, double error)
{
  Json report = ReportOf(result);
  for (const char* part : { "proof", "distance" })
  {
    if (report.contains(part))
    {
      Widen(report[part], move, error);
    }
  }
  if (report.contains("left_out"))
  {
    for (Json& entry : report["left_out"])
    {
      entry["distance"] = entry.value("distance", std::nan("")) + move; // null: not known
    }
  }
  UpdateSentences(report);
  auto widened = vtkSmartPointer<vtkPolyData>::New();
  widened->ShallowCopy(result);
  SetReportOf(std::move(report), widened);
  return widened;
}

/// Points of different coordinates in the first surface that have the same in the second.
vtkIdType CountMeetingPoints(vtkPolyData* result, vtkPolyData* inFile)
{
  std::vector<std::pair<Position, Position>> positions;
  positions.reserve(static_cast<std::size_t>(result->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    positions.emplace_back(PositionOf(inFile, i), PositionOf(result, i));
  }
  std::sort(positions.begin(), positions.end());
  vtkIdType meeting = 0;
  for (std::size_t i = 1; i < positions.size(); ++i)
  {
    const bool isSame = positions[i].first == positions[i - 1].first;
    meeting += isSame && positions[i].second != positions[i - 1].second ? 1 : 0;
  }
  return meeting;
}
}

double MaxRounding(vtkPolyData* surface, const LengthUnit& unit, bool isSingle)
{
  if (unit.IsMillimeter())
  {
    return 0.0;
  }
  constexpr double safety = 1.01; // points of the result may lie a little outside of the input
  const double epsilon = isSingle ? std::numeric_limits<float>::epsilon() / 2.0
                                  : std::numeric_limits<double>::epsilon() * 2.0;
  std::array<double, 6> bounds = {};
  surface->GetBounds(bounds.data());
  double largest = 0.0;
  for (const double bound : bounds)
  {
    largest = std::max(largest, std::abs(bound));
  }
  return safety * std::sqrt(3.0) * epsilon * largest;
}

double KnownError(const Options& options)
{
  Options known = options;
  if (known.VoxelSize > 0.0)
  {
    ApplyPreset(Surface{}, known);
  }
  return known.MaximumError;
}

double ErrorBeforeRounding(
  double error, double rounding, const std::string& unit, const std::string& path)
{
  if (rounding > 0.5 * error)
  {
    Reject(path,
      "written in " + unit + " its coordinates move by up to " + UpperBoundText(rounding, 9) +
        " mm, more than half of the largest error of " + FixedText(error, 9) + " mm");
  }
  return error - rounding;
}

bool HasZeroTolerance(vtkPolyData* surface, const std::string& array)
{
  vtkDataArray* given = surface->GetPointData()->GetArray(array.c_str());
  for (vtkIdType i = 0; given && i < given->GetNumberOfTuples(); ++i)
  {
    if (given->GetComponent(i, 0) == 0.0)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkPolyData> TolerancesBeforeRounding(
  vtkPolyData* surface, const std::string& array, double rounding)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  vtkDataArray* given = surface->GetPointData()->GetArray(array.c_str());
  if (given)
  {
    vtkNew<vtkDoubleArray> less;
    less->DeepCopy(given);
    less->SetName(given->GetName());
    for (vtkIdType i = 0; i < less->GetNumberOfValues(); ++i)
    {
      const double value = less->GetValue(i);
      less->SetValue(i, value > 0.0 ? std::max(0.0, value - rounding) : value);
    }
    result->GetPointData()->AddArray(less);
  }
  return result;
}

vtkSmartPointer<vtkPolyData> WithWidenedBounds(
  vtkPolyData* surface, const std::string& array, double move)
{
  auto widened = vtkSmartPointer<vtkPolyData>::New();
  widened->ShallowCopy(surface);
  if (vtkDataArray* bounds = surface->GetPointData()->GetArray(array.c_str()))
  {
    vtkNew<vtkDoubleArray> wider;
    wider->DeepCopy(bounds);
    for (vtkIdType i = 0; i < wider->GetNumberOfValues(); ++i)
    {
      wider->SetValue(i, wider->GetValue(i) + move);
    }
    widened->GetPointData()->AddArray(wider);
  }
  return widened;
}

RoundedResult RoundForFile(vtkPolyData* result, vtkPolyData* inFile, const RoundedRun& run)
{
  const vtkIdType meeting = run.MergesPoints ? CountMeetingPoints(result, inFile) : 0;
  if (meeting > 0)
  {
    Reject(run.Path,
      "in " + run.Unit.Name + " and single precision, " + std::to_string(meeting) +
        " points of the result would lie on others; " +
        ExtensionsThat(&SurfaceFormat::HoldsDoubles) + " hold double precision");
  }
  const double move = LargestMove(result, inFile, run.Unit);
  const vtkSmartPointer<vtkPolyData> proved =
    WithWidenedBounds(WithWidenedProof(result, move, run.Error), run.BoundArray, move);
  const ReportFields report(proved);
  const double upper =
    report.Number("proof.upper").value_or(std::numeric_limits<double>::infinity());
  const double tolerance = report.Number("proof.tolerance").value_or(0.0);
  if (tolerance > 0.0 && upper > tolerance)
  {
    throw Failure(ExitCode::Undecided,
      "'" + BaseName(run.Path) + "': written in " + run.Unit.Name + ", points move by up to " +
        UpperBoundText(move, 9) + " mm, which exceeds the largest error of " +
        FixedText(tolerance, 9) +
        " mm; give --voxel-size or write double precision; nothing was written");
  }
  return { proved, move };
}
}
