// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by write_options.py from Documentation/options.md.
#include "vtkBoneGoalOptions.h"

#include "RunState.h"

#include <algorithm>
#include <iterator>

namespace
{
// clang-format off
const char* const GoalNames[] = {
  "TargetReduction",
  "MaximumError",
  "ErrorPreset",
  "VoxelSize",
  "NormalTolerance",
  "AutomaticNormalTolerance",
  "MeasureDistances",
  "ProveResult",
};
// clang-format on
}

vtkBoneGoalOptions::vtkBoneGoalOptions() = default;

vtkBoneGoalOptions::~vtkBoneGoalOptions() = default;

void vtkBoneGoalOptions::SetTargetReduction(double value)
{
  this->State->Set(this, "TargetReduction", value);
}

double vtkBoneGoalOptions::GetTargetReduction() const
{
  return this->State->Options.TargetReduction;
}

void vtkBoneGoalOptions::SetMaximumError(double value)
{
  this->State->Set(this, "MaximumError", value);
}

double vtkBoneGoalOptions::GetMaximumError() const
{
  return this->State->Options.MaximumError;
}

void vtkBoneGoalOptions::SetErrorPreset(int value)
{
  this->State->Set(this, "ErrorPreset", value);
}

int vtkBoneGoalOptions::GetErrorPreset() const
{
  return static_cast<int>(this->State->Options.ErrorPreset);
}

void vtkBoneGoalOptions::SetVoxelSize(double value)
{
  this->State->Set(this, "VoxelSize", value);
}

double vtkBoneGoalOptions::GetVoxelSize() const
{
  return this->State->Options.VoxelSize;
}

void vtkBoneGoalOptions::SetNormalTolerance(double value)
{
  this->State->Set(this, "NormalTolerance", value);
}

double vtkBoneGoalOptions::GetNormalTolerance() const
{
  return this->State->Options.NormalTolerance;
}

void vtkBoneGoalOptions::SetAutomaticNormalTolerance(bool value)
{
  this->State->Set(this, "AutomaticNormalTolerance", value);
}

bool vtkBoneGoalOptions::GetAutomaticNormalTolerance() const
{
  return this->State->Options.AutomaticNormalTolerance;
}

void vtkBoneGoalOptions::SetMeasureDistances(bool value)
{
  this->State->Set(this, "MeasureDistances", value);
}

bool vtkBoneGoalOptions::GetMeasureDistances() const
{
  return this->State->Options.MeasureDistances;
}

void vtkBoneGoalOptions::SetProveResult(bool value)
{
  this->State->Set(this, "ProveResult", value);
}

bool vtkBoneGoalOptions::GetProveResult() const
{
  return this->State->Options.ProveResult;
}

//------------------------------------------------------------------------------
void vtkBoneGoalOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const char* name : GoalNames)
  {
    this->State->PrintOption(os, indent, name);
  }
}

bool vtkBoneGoalOptions::HasOption(const std::string& name) const
{
  return std::find(std::begin(GoalNames), std::end(GoalNames), name) != std::end(GoalNames) ||
    this->Superclass::HasOption(name);
}
