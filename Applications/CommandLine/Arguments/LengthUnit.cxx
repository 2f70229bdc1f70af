// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LengthUnit.h"

#include "ExitCode.h"
#include "Files/PointPosition.h"
#include "Files/SurfaceFiles.h"
#include "Formats/SurfaceFormat.h"
#include "HelpFormatter.h"
#include "ReportOfSurface.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace bonedecimate
{
namespace
{
const std::array<LengthUnit, 5> Units = { { { "m", 1000.0, 1.0 }, { "cm", 10.0, 1.0 },
  { "mm", 1.0, 1.0 }, { "um", 1.0, 1000.0 }, { "inch", 127.0, 5.0 } } };

void SetUnit(LengthUnit& unit, const std::string& name)
{
  std::string names;
  for (const LengthUnit& one : Units)
  {
    if (one.Name == name)
    {
      unit = one;
      unit.IsRequested = true;
      return;
    }
    names += (names.empty() ? "" : ", ") + one.Name;
  }
  throw Failure(ExitCode::Usage, "--unit takes one of " + names + ", not '" + name + "'");
}

LengthUnit UnitOfName(const std::string& name)
{
  LengthUnit unit;
  SetUnit(unit, name);
  return unit;
}

using Position = std::array<double, 3>;

template <typename Convert>
Position Converted(Position position, const Convert& convert)
{
  std::transform(position.begin(), position.end(), position.begin(), convert);
  return position;
}

/// @param convert A position to a position.
template <typename Convert>
vtkSmartPointer<vtkPolyData> WithPoints(vtkPolyData* surface, int precision, const Convert& convert)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, convert(PositionOf(surface, i)).data());
  }
  auto converted = vtkSmartPointer<vtkPolyData>::New();
  converted->ShallowCopy(surface);
  converted->SetPoints(points);
  return converted;
}

/// From positions in millimeters to those of the file, as far as the conversion back would not find
/// them.
class Originals
{
public:
  Originals(vtkPolyData* input, const LengthUnit& unit)
    : Unit(unit)
  {
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      const Position inFile = PositionOf(input, i);
      const Position position =
        Converted(inFile, [&unit](double coordinate) { return unit.ToMillimeters(coordinate); });
      if (this->Nearest(position) != inFile)
      {
        this->Positions.emplace_back(position, inFile);
      }
    }
    std::sort(this->Positions.begin(), this->Positions.end());
  }

  Position Find(const Position& position) const
  {
    const auto found = std::lower_bound(this->Positions.begin(), this->Positions.end(), position,
      [](const std::pair<Position, Position>& entry, const Position& key)
      { return entry.first < key; });
    const bool isThere = found != this->Positions.end() && found->first == position;
    return isThere ? found->second : this->Nearest(position);
  }

private:
  Position Nearest(const Position& position) const
  {
    return Converted(
      position, [this](double coordinate) { return this->Unit.FromMillimeters(coordinate); });
  }

  const LengthUnit& Unit;
  std::vector<std::pair<Position, Position>> Positions;
};
}

double LengthUnit::FromMillimeters(double millimeters) const
{
  const double nearest = millimeters * this->Divisor / this->Factor;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double candidate :
    { nearest, std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity) })
  {
    if (this->ToMillimeters(candidate) == millimeters)
    {
      return candidate;
    }
  }
  return nearest;
}

LengthUnit UnitOfFile(const std::string& path, const LengthUnit& requested)
{
  const SurfaceFormat* const format = FindFormat(path);
  return format != nullptr && format->NamesUnit ? LengthUnit() : requested;
}

LengthUnit UnitOfFiles(
  const std::vector<const SurfaceFormat*>& formats, const LengthUnit& requested)
{
  const bool isNamed = std::all_of(
    formats.begin(), formats.end(), [](const SurfaceFormat* format) { return format->NamesUnit; });
  return isNamed ? LengthUnit() : requested;
}

void AddUnit(CLI::App& app, LengthUnit& unit)
{
  app
    .add_option_function<std::string>(
      "--unit", [&unit](const std::string& name) { SetUnit(unit, name); },
      WrappedHelp("The unit of the coordinates in files of surfaces, read and written; default mm. "
                  "Options, reports, arrays and pages are in millimeters whatever it is, and files "
                  "that name their unit (" +
        ExtensionsThat(&SurfaceFormat::NamesUnit) +
        ") are read and written in that. Of files of other programs in " +
        ExtensionsThat(&SurfaceFormat::UnitMayDiffer) + " it is the unit instead of m."))
    ->type_name("m|cm|mm|um|inch");
}

MillimeterSurface ReadInMillimeters(const std::string& path, const LengthUnit& unit)
{
  const LoadedSurface loaded = ReadSurface(path);
  MillimeterSurface surface;
  surface.Warnings = loaded.Warnings;
  surface.InFile = loaded.Surface;
  LengthUnit used = UnitOfFile(path, unit);
  surface.TakesUnit = loaded.Unit.empty() ? !FindFormat(path)->NamesUnit : loaded.Unit != "mm";
  if (surface.TakesUnit && !loaded.Unit.empty())
  {
    used = unit.IsRequested ? unit : UnitOfName(loaded.Unit);
    surface.Note = "the input is of another program: its lengths are in " + used.Name +
      (unit.IsRequested ? std::string() : ", as its format says (--unit tells another unit)") +
      ", its axes are kept as they are, and this format has y up";
  }
  surface.Surface = ToMillimeters(loaded.Surface, used);
  return surface;
}

vtkSmartPointer<vtkPolyData> ToMillimeters(vtkPolyData* surface, const LengthUnit& unit)
{
  const auto convert = [&unit](const Position& position)
  {
    return Converted(
      position, [&unit](double coordinate) { return unit.ToMillimeters(coordinate); });
  };
  return unit.IsMillimeter() ? vtkSmartPointer<vtkPolyData>(surface)
                             : WithPoints(surface, VTK_DOUBLE, convert);
}

vtkSmartPointer<vtkPolyData> FromMillimeters(
  vtkPolyData* surface, const LengthUnit& unit, bool toSingle, vtkPolyData* input)
{
  if (unit.IsMillimeter())
  {
    return surface;
  }
  const Originals originals(input, unit);
  const vtkSmartPointer<vtkPolyData> converted =
    WithPoints(surface, toSingle ? VTK_FLOAT : VTK_DOUBLE,
      [&originals](const Position& position) { return originals.Find(position); });
  if (nlohmann::ordered_json report = ReportOf(surface);
      report.contains("/proof/upper"_json_pointer))
  {
    SetReportOf(std::move(report), converted); // in millimeters, of the surface in the file
  }
  return converted;
}

std::string WithUnitHint(std::string message, const std::string& source, const LengthUnit& unit)
{
  const std::string doubt = "may not be in millimeters";
  const std::string option = "--allow-large-error";
  const SurfaceFormat* const format = FindFormat(source);
  const bool takesUnit = format != nullptr && (!format->NamesUnit || format->UnitMayDiffer);
  if (const std::size_t at = message.find(doubt); at != std::string::npos && takesUnit)
  {
    message.replace(at, doubt.size(),
      unit.IsMillimeter() ? doubt + ", --unit tells their unit"
                          : "may not be in the unit of --unit, " + unit.Name);
  }
  if (const std::size_t at = message.find(option); at != std::string::npos)
  {
    message.replace(at, option.size(), option + " on");
  }
  return message;
}
}
