// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputArguments.h"

#include "Arguments.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "Files/SurfaceFiles.h"
#include "Formats/FileChecks.h"
#include "HelpFormatter.h"
#include "NamedArrays.h"

#include "vtkBoneDecimateAlgorithm.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <utility>

namespace bonedecimate
{
void AddRegions(
  CLI::App& app, std::vector<Region>& regions, const std::function<void(const std::string&)>& given)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--region",
      [&regions, given](const std::vector<std::string>& texts)
      {
        std::string all;
        for (const std::string& text : texts)
        {
          const std::string problem = ReadRegions(text, regions);
          if (!problem.empty())
          {
            throw Failure(ExitCode::Usage, "--region " + problem);
          }
          all += (all.empty() ? "" : ";") + text;
        }
        if (given)
        {
          given(all);
        }
      },
      WrappedHelp(
        "How far the surface may move in a part of it, in mm: box:x0,x1,y0,y1,z0,z1=MM, "
        "sphere:x,y,z,radius=MM, rest=MM for what is in none of them. 0 keeps it unchanged; "
        "where parts overlap the smallest counts, and --max-error caps all. May be "
        "repeated."))
    ->type_name("SHAPE=MM")
    ->expected(1)
    ->take_all()
    ->allow_extra_args(false);
}

//------------------------------------------------------------------------------
void AddInputArguments(CLI::App& app, InputArguments& arguments)
{
  AddRegions(app, arguments.Regions);
  AddOptionOfTable(app, *FindOption("ToleranceArrayName"),
    [&arguments](const OptionInfo&, const std::string& text) { arguments.ToleranceArray = text; });
  AddOptionOfTable(app, *FindOption("LabelArrayName"),
    [&arguments](const OptionInfo&, const std::string& text) { arguments.LabelArray = text; });
  AddFile(app, "--reference", "SURFACE", arguments.Reference,
    "The first surface, if INPUT is itself a result: errors are proved against it.");
}

//------------------------------------------------------------------------------
void NeedPointArray(vtkPolyData* surface, const std::string& array, const std::string& path)
{
  if (!array.empty() && !surface->GetPointData()->HasArray(array.c_str()))
  {
    Reject(path,
      "it has no point array '" + array + "' (there are: " + ListOfArrays(surface->GetPointData()) +
        ")");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ApplyRegions(const std::vector<Region>& regions, std::string array,
  const std::string& path, vtkSmartPointer<vtkPolyData> surface, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings)
{
  NeedPointArray(surface, array, path);
  if (regions.empty())
  {
    return surface;
  }
  if (array.empty())
  {
    array = "Tolerance";
    // A result of an earlier run still has that run's.
    vtkNew<vtkPolyData> without;
    without->ShallowCopy(surface);
    without->GetPointData()->RemoveArray(array.c_str());
    surface = without;
  }
  for (const std::string& region : RegionsWithoutPoints(surface, regions))
  {
    warnings.push_back("no point of the surface lies in " + region);
  }
  filter->SetOptionFromText("ToleranceArrayName", array);
  return WithTolerances(surface, regions, array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ApplyInputArguments(const InputArguments& arguments,
  const std::string& path, vtkSmartPointer<vtkPolyData> surface, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings)
{
  filter->SetOptionFromText("ToleranceArrayName", arguments.ToleranceArray);
  filter->SetOptionFromText("LabelArrayName", arguments.LabelArray);
  return ApplyRegions(
    arguments.Regions, arguments.ToleranceArray, path, std::move(surface), filter, warnings);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadReference(const InputArguments& arguments, const LengthUnit& unit)
{
  return arguments.Reference.empty() ? nullptr
                                     : ReadInMillimeters(arguments.Reference, unit).Surface;
}
}
