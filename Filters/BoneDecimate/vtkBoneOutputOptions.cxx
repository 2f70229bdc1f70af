// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by write_options.py from Documentation/options.md.
#include "vtkBoneOutputOptions.h"

#include "RunState.h"

#include <algorithm>
#include <iterator>

namespace
{
// clang-format off
const char* const OutputNames[] = {
  "MeasureInputDistances",
  "OutputPointsPrecision",
  "OutputPointsGrid",
  "PassArrays",
  "MakeMaps",
  "RecomputeNormals",
  "DistanceArrayName",
  "RunningErrorArrayName",
  "PointCountArrayName",
  "InputDistanceArrayName",
  "ErrorBoundArrayName",
  "InputErrorBoundArrayName",
  "PruneSize",
  "PruneArea",
  "PruneVolume",
  "PruneTriangles",
  "TunnelSize",
  "DiagnoseInput",
};
// clang-format on
}

vtkBoneOutputOptions::vtkBoneOutputOptions() = default;

vtkBoneOutputOptions::~vtkBoneOutputOptions() = default;

void vtkBoneOutputOptions::SetMeasureInputDistances(bool value)
{
  this->State->Set(this, "MeasureInputDistances", value);
}

bool vtkBoneOutputOptions::GetMeasureInputDistances() const
{
  return this->State->Options.MeasureInputDistances;
}

void vtkBoneOutputOptions::SetOutputPointsPrecision(int value)
{
  this->State->Set(this, "OutputPointsPrecision", value);
}

int vtkBoneOutputOptions::GetOutputPointsPrecision() const
{
  return static_cast<int>(this->State->Options.OutputPointsPrecision);
}

void vtkBoneOutputOptions::SetOutputPointsGrid(double value)
{
  this->State->Set(this, "OutputPointsGrid", value);
}

double vtkBoneOutputOptions::GetOutputPointsGrid() const
{
  return this->State->Options.OutputPointsGrid;
}

void vtkBoneOutputOptions::SetPassArrays(bool value)
{
  this->State->Set(this, "PassArrays", value);
}

bool vtkBoneOutputOptions::GetPassArrays() const
{
  return this->State->Options.PassArrays;
}

void vtkBoneOutputOptions::SetMakeMaps(bool value)
{
  this->State->Set(this, "MakeMaps", value);
}

bool vtkBoneOutputOptions::GetMakeMaps() const
{
  return this->State->Options.MakeMaps;
}

void vtkBoneOutputOptions::SetRecomputeNormals(bool value)
{
  this->State->Set(this, "RecomputeNormals", value);
}

bool vtkBoneOutputOptions::GetRecomputeNormals() const
{
  return this->State->Options.RecomputeNormals;
}

void vtkBoneOutputOptions::SetDistanceArrayName(const std::string& value)
{
  this->State->Set(this, "DistanceArrayName", value);
}

std::string vtkBoneOutputOptions::GetDistanceArrayName() const
{
  return this->State->Options.DistanceArrayName;
}

void vtkBoneOutputOptions::SetRunningErrorArrayName(const std::string& value)
{
  this->State->Set(this, "RunningErrorArrayName", value);
}

std::string vtkBoneOutputOptions::GetRunningErrorArrayName() const
{
  return this->State->Options.RunningErrorArrayName;
}

void vtkBoneOutputOptions::SetPointCountArrayName(const std::string& value)
{
  this->State->Set(this, "PointCountArrayName", value);
}

std::string vtkBoneOutputOptions::GetPointCountArrayName() const
{
  return this->State->Options.PointCountArrayName;
}

void vtkBoneOutputOptions::SetInputDistanceArrayName(const std::string& value)
{
  this->State->Set(this, "InputDistanceArrayName", value);
}

std::string vtkBoneOutputOptions::GetInputDistanceArrayName() const
{
  return this->State->Options.InputDistanceArrayName;
}

void vtkBoneOutputOptions::SetErrorBoundArrayName(const std::string& value)
{
  this->State->Set(this, "ErrorBoundArrayName", value);
}

std::string vtkBoneOutputOptions::GetErrorBoundArrayName() const
{
  return this->State->Options.ErrorBoundArrayName;
}

void vtkBoneOutputOptions::SetInputErrorBoundArrayName(const std::string& value)
{
  this->State->Set(this, "InputErrorBoundArrayName", value);
}

std::string vtkBoneOutputOptions::GetInputErrorBoundArrayName() const
{
  return this->State->Options.InputErrorBoundArrayName;
}

void vtkBoneOutputOptions::SetPruneSize(double value)
{
  this->State->Set(this, "PruneSize", value);
}

double vtkBoneOutputOptions::GetPruneSize() const
{
  return this->State->Options.PruneSize;
}

void vtkBoneOutputOptions::SetPruneArea(double value)
{
  this->State->Set(this, "PruneArea", value);
}

double vtkBoneOutputOptions::GetPruneArea() const
{
  return this->State->Options.PruneArea;
}

void vtkBoneOutputOptions::SetPruneVolume(double value)
{
  this->State->Set(this, "PruneVolume", value);
}

double vtkBoneOutputOptions::GetPruneVolume() const
{
  return this->State->Options.PruneVolume;
}

void vtkBoneOutputOptions::SetPruneTriangles(int value)
{
  this->State->Set(this, "PruneTriangles", value);
}

int vtkBoneOutputOptions::GetPruneTriangles() const
{
  return this->State->Options.PruneTriangles;
}

void vtkBoneOutputOptions::SetTunnelSize(double value)
{
  this->State->Set(this, "TunnelSize", value);
}

double vtkBoneOutputOptions::GetTunnelSize() const
{
  return this->State->Options.TunnelSize;
}

void vtkBoneOutputOptions::SetDiagnoseInput(bool value)
{
  this->State->Set(this, "DiagnoseInput", value);
}

bool vtkBoneOutputOptions::GetDiagnoseInput() const
{
  return this->State->Options.DiagnoseInput;
}

//------------------------------------------------------------------------------
void vtkBoneOutputOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const char* name : OutputNames)
  {
    this->State->PrintOption(os, indent, name);
  }
}

bool vtkBoneOutputOptions::HasOption(const std::string& name) const
{
  return std::find(std::begin(OutputNames), std::end(OutputNames), name) != std::end(OutputNames) ||
    this->Superclass::HasOption(name);
}
