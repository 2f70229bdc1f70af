// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterOptions.h"

#include "Formats/SurfaceFormat.h"
#include "Options/OptionTable.h"
#include "Segments/SegmentOutput.h"

#include <algorithm>

namespace bonedecimate
{
void ApplyOptions(const Options& options, vtkBoneDecimate* filter)
{
  for (const OptionInfo& info : OptionTable())
  {
    if (info.Name != "TargetReduction" || options.TargetReductionIsExplicit)
    {
      filter->SetOptionFromText(info.Name, OptionText(options, info));
    }
  }
}

//------------------------------------------------------------------------------
int ModeNumber(const std::string& name)
{
  Options options;
  SetOptionFromText(options, *FindOption("Mode"), name);
  return static_cast<int>(options.Mode);
}

//------------------------------------------------------------------------------
Options OptionsForFiles(const Arguments& arguments)
{
  Options options = arguments.Options;
  const std::vector<const SurfaceFormat*> formats = FormatsOfSurfaces(arguments);
  const auto isSingle = [](const SurfaceFormat* format) { return !format->HoldsDoubles; };
  const bool isLimited =
    (!options.ToleranceArrayName.empty() || !arguments.Regions.empty()) && options.ProvesError();
  if ((options.BoundsError() || isLimited || options.Smooths()) &&
    std::any_of(formats.begin(), formats.end(), isSingle))
  {
    options.OutputPointsPrecision = PointsPrecision::Single;
  }
  if (arguments.Segments.IsRequested())
  {
    options = options.WithoutPruning(); // the voxels went before
  }
  return options;
}
}
