// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabOptions.h"

#include "Options/OptionTable.h"
#include "Options/RunKinds.h"
#include "Run/Input/VoxelSize.h"

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
  if (!options.BoundsError())
  {
    return "A run in slabs needs a MaximumError, in a mode that proves it.";
  }
  const std::string unsupported = FindUnsupported({ FindRunKind("Slabs") }, RequestsOf(options));
  return unsupported.empty() ? unsupported : unsupported + ".";
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
