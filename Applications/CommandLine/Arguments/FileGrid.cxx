// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileGrid.h"

#include "Base/Text.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "Figures/BoundText.h"
#include "Formats/FileChecks.h"
#include "Formats/GlbFiles.h"
#include "Formats/SurfaceFormat.h"
#include "HelpFormatter.h"
#include "NumberText.h"
#include "Segments/SegmentOutput.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// How far outside of a surface its result may lie where no error bounds it, as a fraction of the
/// diagonal.
constexpr double MarginOfSize = 1.0 / 64.0;

bool HasGrid(const SurfaceFormat* format)
{
  return format != nullptr && format->HasGrid;
}
}

void AddFileOptions(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--position-bits", "N", { LeastPositionBits, MostPositionBits, true, "bits" },
      "Outputs in glb: how many bits a coordinate has across the surface; default 16. The rounding "
      "is part of --max-error." },
    [&arguments](double bits)
    {
      arguments.PositionBits = static_cast<int>(bits);
      arguments.Given["position-bits"] = std::to_string(arguments.PositionBits);
    });
  AddGlbCompression(app, arguments.CompressesGlb,
    [&arguments](const std::string& value) { arguments.Given["glb-compression"] = value; });
  app
    .add_option_function<std::string>(
      "--vertex-colors",
      [&arguments](const std::string&)
      {
        arguments.ColorsErrors = true;
        arguments.Given["vertex-colors"] = "error";
      },
      WrappedHelp("Outputs in glb: color each point by its proved bound, or by its distance to the "
                  "input where nothing is proved, from white at 0 to red at --max-error."))
    ->type_name("error")
    ->check(OneOf("error"));
}

void AddGlbCompression(
  CLI::App& app, bool& compresses, const std::function<void(const std::string&)>& given)
{
  app
    .add_option_function<std::string>(
      "--glb-compression",
      [&compresses, given](const std::string& value)
      {
        compresses = value == "meshopt";
        given(value);
      },
      WrappedHelp("Outputs in glb: none, which every program reads that reads glb, or meshopt "
                  "(EXT_meshopt_compression), about a third of the bytes, which web viewers read; "
                  "default none."))
    ->type_name("none|meshopt")
    ->check(OneOf("none|meshopt"));
}

bool WritesGrid(const Arguments& arguments)
{
  const std::vector<const SurfaceFormat*> formats = FormatsOfSurfaces(arguments);
  return std::any_of(formats.begin(), formats.end(), HasGrid);
}

void CheckFileOptions(const Arguments& arguments)
{
  const bool isKnown = !IsBatch(arguments) || !arguments.Format.empty();
  const bool writesGrid = IsBatch(arguments) && !arguments.Format.empty()
    ? HasGrid(FindFormat("x." + arguments.Format))
    : WritesGrid(arguments);
  for (const char* flag : { "position-bits", "glb-compression", "vertex-colors" })
  {
    RequireUsage(!isKnown || writesGrid || arguments.Given.count(flag) == 0,
      std::string("--") + flag + " has no effect; it needs an output in " +
        ExtensionsThat(&SurfaceFormat::HasGrid));
  }
}

double GridStepFor(vtkPolyData* surface, double error, int bits, const std::string& path)
{
  const double margin = error > 0.0 ? error : MarginOfSize * surface->GetLength();
  const double step = GridStepOf(surface, margin, bits);
  const double rounding = LargestGridRounding(step);
  if (error > 0.0 && rounding > 0.5 * error)
  {
    Reject(path,
      "in " + std::to_string(bits) + " bits its coordinates are multiples of " +
        FixedText(step, DecimalsOfRounding) + " mm and move by up to " +
        UpperBoundText(rounding, DecimalsOfRounding) +
        " mm, more than half of the largest error of " + FixedText(error, DecimalsOfRounding) +
        " mm; " + (bits < MostPositionBits ? "--position-bits 16 or " : std::string()) +
        "another format rounds less");
  }
  return step;
}

std::string GridNote(double step, bool isBounded)
{
  return "glb: coordinates are whole multiples of " + NumberText(step) +
    " mm; points are rounded by up to " +
    UpperBoundText(LargestGridRounding(step), DecimalsOfRounding) + " mm" +
    (isBounded ? ", which the largest error includes" : "");
}

std::vector<std::string> GridWarnings(vtkPolyData* surface, double step, bool mergesPoints)
{
  std::vector<std::array<double, 3>> points(
    static_cast<std::size_t>(mergesPoints ? surface->GetNumberOfPoints() : 0));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::sort(points.begin(), points.end());
  const auto distinct = std::unique(points.begin(), points.end()) - points.begin();
  const auto coincident = static_cast<std::ptrdiff_t>(points.size()) - distinct;
  return coincident == 0 ? std::vector<std::string>()
                         : std::vector<std::string>{ GroupedText(static_cast<double>(coincident)) +
                             " points lie on others after rounding to multiples of " +
                             NumberText(step) + " mm; with --max-error they are kept apart" };
}

vtkSmartPointer<vtkPolyData> WithErrorColors(
  vtkPolyData* surface, const std::vector<std::string>& arrays, double error)
{
  vtkDataArray* values = nullptr;
  for (const std::string& name : arrays)
  {
    values = values != nullptr ? values : surface->GetPointData()->GetArray(name.c_str());
  }
  if (values == nullptr)
  {
    throw Failure(ExitCode::Usage,
      "--vertex-colors error needs what --max-error proves or --measure on measures");
  }
  const double most = error > 0.0 ? error : std::max(values->GetRange(0)[1], 1e-300);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(VertexColorArray);
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double fraction = std::clamp(values->GetComponent(i, 0) / most, 0.0, 1.0);
    const auto rest = static_cast<unsigned char>(std::lround(255.0 * (1.0 - fraction)));
    const std::array<unsigned char, 3> color = { 255, rest, rest };
    colors->InsertNextTypedTuple(color.data());
  }
  auto colored = vtkSmartPointer<vtkPolyData>::New();
  colored->ShallowCopy(surface);
  colored->GetPointData()->AddArray(colors);
  return colored;
}
}
