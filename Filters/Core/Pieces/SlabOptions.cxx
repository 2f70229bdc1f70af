// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabOptions.h"

#include "Input/VoxelSize.h"
#include "Options/OptionTable.h"

namespace bonedecimate
{
namespace
{
/// Empty if all options can be followed.
std::string WhatIsWrong(const Options& options)
{
  const std::string wrong = CheckOptions(options);
  if (!wrong.empty())
  {
    return wrong;
  }
  if (!options.ProvesError() || !(options.MaximumError > 0.0))
  {
    return "A run in slabs needs a MaximumError, in a mode that proves it.";
  }
  if (options.ErrorPreset != ErrorPreset::NoPreset)
  {
    return "A run in slabs needs the VoxelSize of its ErrorPreset, because a slab does not tell "
           "it.";
  }
  if (options.TargetNumberOfTriangles > 0 || options.TargetReductionIsExplicit)
  {
    return "A run in slabs does not know the whole surface, so it has no target number of "
           "triangles.";
  }
  if (options.Smooths())
  {
    return "A run in slabs does not smooth.";
  }
  if (options.OutputPointsGrid > 0.0)
  {
    return "A run in slabs does not round points to a grid.";
  }
  if (options.Prunes())
  {
    return "A run in slabs does not remove components, because it does not know them as a whole.";
  }
  if (options.TunnelSize > 0.0)
  {
    return "A run in slabs does not close tunnels, because it does not know them as a whole.";
  }
  if (options.MeasureInputDistances || options.DiagnoseInput)
  {
    return "A run in slabs does not keep the input, so it neither measures nor diagnoses it.";
  }
  return options.MergePoints ? "" : "A run in slabs merges points, because this joins the slabs.";
}
}

Options OptionsOfSlabs(const Options& options, const SlabInputs& inputs, std::string& message)
{
  Options effective = options;
  const VoxelGrid& grid = inputs.LabelMap.Grid;
  if (effective.VoxelSize == 0.0 && grid.Dimensions[0] > 0)
  {
    effective.VoxelSize = grid.Spacing.minCoeff();
  }
  if (effective.VoxelSize > 0.0)
  {
    ApplyPreset({}, effective);
  }
  message = WhatIsWrong(effective);
  effective.MeasureDistances = false;
  effective.AllowLargeError = true; // the size of a slab says nothing about the whole
  return effective;
}
}
