// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by write_options.py from Documentation/options.md.
#include "vtkBoneRunOptions.h"

#include "RunState.h"

#include <algorithm>
#include <iterator>

namespace
{
// clang-format off
const char* const RunNames[] = {
  "Mode",
  "TargetNumberOfTriangles",
  "Smoothing",
  "AutomaticSmoothing",
  "FeatureAngle",
  "KeepVoxels",
  "ToleranceArrayName",
  "LabelArrayName",
  "AllowLargeError",
  "IntersectionGuard",
  "RefinementEffort",
  "MinimumAngle",
  "EdgeLength",
  "EdgeLengthArrayName",
  "ChordalError",
  "MergePoints",
  "NumberOfThreads",
};
// clang-format on
}

vtkBoneRunOptions::vtkBoneRunOptions() = default;

vtkBoneRunOptions::~vtkBoneRunOptions() = default;

void vtkBoneRunOptions::SetMode(int value)
{
  this->State->Set(this, "Mode", value);
}

int vtkBoneRunOptions::GetMode() const
{
  return static_cast<int>(this->State->Options.Mode);
}

void vtkBoneRunOptions::SetTargetNumberOfTriangles(int value)
{
  this->State->Set(this, "TargetNumberOfTriangles", value);
}

int vtkBoneRunOptions::GetTargetNumberOfTriangles() const
{
  return this->State->Options.TargetNumberOfTriangles;
}

void vtkBoneRunOptions::SetSmoothing(double value)
{
  this->State->Set(this, "Smoothing", value);
}

double vtkBoneRunOptions::GetSmoothing() const
{
  return this->State->Options.Smoothing;
}

void vtkBoneRunOptions::SetAutomaticSmoothing(bool value)
{
  this->State->Set(this, "AutomaticSmoothing", value);
}

bool vtkBoneRunOptions::GetAutomaticSmoothing() const
{
  return this->State->Options.AutomaticSmoothing;
}

void vtkBoneRunOptions::SetFeatureAngle(double value)
{
  this->State->Set(this, "FeatureAngle", value);
}

double vtkBoneRunOptions::GetFeatureAngle() const
{
  return this->State->Options.FeatureAngle;
}

void vtkBoneRunOptions::SetKeepVoxels(int value)
{
  this->State->Set(this, "KeepVoxels", value);
}

int vtkBoneRunOptions::GetKeepVoxels() const
{
  return static_cast<int>(this->State->Options.KeepVoxels);
}

void vtkBoneRunOptions::SetToleranceArrayName(const std::string& value)
{
  this->State->Set(this, "ToleranceArrayName", value);
}

std::string vtkBoneRunOptions::GetToleranceArrayName() const
{
  return this->State->Options.ToleranceArrayName;
}

void vtkBoneRunOptions::SetLabelArrayName(const std::string& value)
{
  this->State->Set(this, "LabelArrayName", value);
}

std::string vtkBoneRunOptions::GetLabelArrayName() const
{
  return this->State->Options.LabelArrayName;
}

void vtkBoneRunOptions::SetAllowLargeError(bool value)
{
  this->State->Set(this, "AllowLargeError", value);
}

bool vtkBoneRunOptions::GetAllowLargeError() const
{
  return this->State->Options.AllowLargeError;
}

void vtkBoneRunOptions::SetIntersectionGuard(bool value)
{
  this->State->Set(this, "IntersectionGuard", value);
}

bool vtkBoneRunOptions::GetIntersectionGuard() const
{
  return this->State->Options.IntersectionGuard;
}

void vtkBoneRunOptions::SetRefinementEffort(double value)
{
  this->State->Set(this, "RefinementEffort", value);
}

double vtkBoneRunOptions::GetRefinementEffort() const
{
  return this->State->Options.RefinementEffort;
}

void vtkBoneRunOptions::SetMinimumAngle(double value)
{
  this->State->Set(this, "MinimumAngle", value);
}

double vtkBoneRunOptions::GetMinimumAngle() const
{
  return this->State->Options.MinimumAngle;
}

void vtkBoneRunOptions::SetEdgeLength(double value)
{
  this->State->Set(this, "EdgeLength", value);
}

double vtkBoneRunOptions::GetEdgeLength() const
{
  return this->State->Options.EdgeLength;
}

void vtkBoneRunOptions::SetEdgeLengthArrayName(const std::string& value)
{
  this->State->Set(this, "EdgeLengthArrayName", value);
}

std::string vtkBoneRunOptions::GetEdgeLengthArrayName() const
{
  return this->State->Options.EdgeLengthArrayName;
}

void vtkBoneRunOptions::SetChordalError(double value)
{
  this->State->Set(this, "ChordalError", value);
}

double vtkBoneRunOptions::GetChordalError() const
{
  return this->State->Options.ChordalError;
}

void vtkBoneRunOptions::SetMergePoints(bool value)
{
  this->State->Set(this, "MergePoints", value);
}

bool vtkBoneRunOptions::GetMergePoints() const
{
  return this->State->Options.MergePoints;
}

void vtkBoneRunOptions::SetNumberOfThreads(int value)
{
  this->State->Set(this, "NumberOfThreads", value);
}

int vtkBoneRunOptions::GetNumberOfThreads() const
{
  return this->State->Options.NumberOfThreads;
}

//------------------------------------------------------------------------------
void vtkBoneRunOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const char* name : RunNames)
  {
    this->State->PrintOption(os, indent, name);
  }
}

bool vtkBoneRunOptions::HasOption(const std::string& name) const
{
  return std::find(std::begin(RunNames), std::end(RunNames), name) != std::end(RunNames) ||
    this->Superclass::HasOption(name);
}
