// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by write_options.py from Documentation/options.md.
#include "vtkBoneSmoothOptions.h"

#include "RunState.h"

#include <algorithm>
#include <iterator>

namespace
{
// clang-format off
const char* const SmoothNames[] = {
  "Smoothing",
  "FeatureAngle",
  "MaximumError",
  "ToleranceArrayName",
  "LabelArrayName",
  "MergePoints",
  "MeasureDistances",
  "ProveResult",
  "PassArrays",
  "OutputPointsPrecision",
  "RecomputeNormals",
  "AllowLargeError",
  "NumberOfThreads",
};
// clang-format on
}

vtkBoneSmoothOptions::vtkBoneSmoothOptions() = default;

vtkBoneSmoothOptions::~vtkBoneSmoothOptions() = default;

void vtkBoneSmoothOptions::SetSmoothing(double value)
{
  this->State->Set(this, "Smoothing", value);
}

double vtkBoneSmoothOptions::GetSmoothing() const
{
  return this->State->Options.Smoothing;
}

void vtkBoneSmoothOptions::SetFeatureAngle(double value)
{
  this->State->Set(this, "FeatureAngle", value);
}

double vtkBoneSmoothOptions::GetFeatureAngle() const
{
  return this->State->Options.FeatureAngle;
}

void vtkBoneSmoothOptions::SetMaximumError(double value)
{
  this->State->Set(this, "MaximumError", value);
}

double vtkBoneSmoothOptions::GetMaximumError() const
{
  return this->State->Options.MaximumError;
}

void vtkBoneSmoothOptions::SetToleranceArrayName(const std::string& value)
{
  this->State->Set(this, "ToleranceArrayName", value);
}

std::string vtkBoneSmoothOptions::GetToleranceArrayName() const
{
  return this->State->Options.ToleranceArrayName;
}

void vtkBoneSmoothOptions::SetLabelArrayName(const std::string& value)
{
  this->State->Set(this, "LabelArrayName", value);
}

std::string vtkBoneSmoothOptions::GetLabelArrayName() const
{
  return this->State->Options.LabelArrayName;
}

void vtkBoneSmoothOptions::SetMergePoints(bool value)
{
  this->State->Set(this, "MergePoints", value);
}

bool vtkBoneSmoothOptions::GetMergePoints() const
{
  return this->State->Options.MergePoints;
}

void vtkBoneSmoothOptions::SetMeasureDistances(bool value)
{
  this->State->Set(this, "MeasureDistances", value);
}

bool vtkBoneSmoothOptions::GetMeasureDistances() const
{
  return this->State->Options.MeasureDistances;
}

void vtkBoneSmoothOptions::SetProveResult(bool value)
{
  this->State->Set(this, "ProveResult", value);
}

bool vtkBoneSmoothOptions::GetProveResult() const
{
  return this->State->Options.ProveResult;
}

void vtkBoneSmoothOptions::SetPassArrays(bool value)
{
  this->State->Set(this, "PassArrays", value);
}

bool vtkBoneSmoothOptions::GetPassArrays() const
{
  return this->State->Options.PassArrays;
}

void vtkBoneSmoothOptions::SetOutputPointsPrecision(int value)
{
  this->State->Set(this, "OutputPointsPrecision", value);
}

int vtkBoneSmoothOptions::GetOutputPointsPrecision() const
{
  return static_cast<int>(this->State->Options.OutputPointsPrecision);
}

void vtkBoneSmoothOptions::SetRecomputeNormals(bool value)
{
  this->State->Set(this, "RecomputeNormals", value);
}

bool vtkBoneSmoothOptions::GetRecomputeNormals() const
{
  return this->State->Options.RecomputeNormals;
}

void vtkBoneSmoothOptions::SetAllowLargeError(bool value)
{
  this->State->Set(this, "AllowLargeError", value);
}

bool vtkBoneSmoothOptions::GetAllowLargeError() const
{
  return this->State->Options.AllowLargeError;
}

void vtkBoneSmoothOptions::SetNumberOfThreads(int value)
{
  this->State->Set(this, "NumberOfThreads", value);
}

int vtkBoneSmoothOptions::GetNumberOfThreads() const
{
  return this->State->Options.NumberOfThreads;
}

//------------------------------------------------------------------------------
void vtkBoneSmoothOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const char* name : SmoothNames)
  {
    this->State->PrintOption(os, indent, name);
  }
}

bool vtkBoneSmoothOptions::HasOption(const std::string& name) const
{
  return std::find(std::begin(SmoothNames), std::end(SmoothNames), name) != std::end(SmoothNames) ||
    this->Superclass::HasOption(name);
}
