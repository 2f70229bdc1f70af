// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputRounding.h"

#include "Arguments/FileGrid.h"
#include "Figures/BoundText.h"
#include "FileRounding.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "ReportFields.h"
#include "Segments/SegmentOutput.h"

#include "vtkPointData.h"

namespace bonedecimate
{
OutputRounding::OutputRounding(const Arguments& arguments)
  : Requested(arguments)
  , Path(arguments.Inputs[0])
  , Unit(UnitOfFiles(FormatsOfSurfaces(arguments), arguments.Unit))
{
}

void OutputRounding::SetInput(vtkPolyData* input, vtkPolyData* inFile)
{
  this->Input = input;
  this->InputInFile = inFile;
  this->IsSingle = inFile != nullptr && inFile->GetPoints()->GetDataType() == VTK_FLOAT;
}

void OutputRounding::Reserve(Options& options)
{
  const double error = options.BoundsError() ? KnownError(options) : 0.0;
  if (WritesGrid(this->Requested))
  {
    options.OutputPointsGrid =
      GridStepFor(this->Input, error, this->Requested.PositionBits, this->Path);
  }
  if (this->Unit.IsMillimeter())
  {
    return;
  }
  this->WritesSingle = options.WritesSingle(this->IsSingle);
  options.OutputPointsPrecision = PointsPrecision::Double;
  const bool isLimited = !options.ToleranceArrayName.empty() || !this->Requested.Regions.empty();
  if (options.BoundsError() || (isLimited && options.ProvesError()))
  {
    this->Rounding = MaxRounding(this->Input, this->Unit, this->WritesSingle);
  }
  this->Error = error;
  if (this->Error > 0.0)
  {
    options.MaximumError =
      ErrorBeforeRounding(this->Error, this->Rounding, this->Unit.Name, this->Path);
  }
}

vtkSmartPointer<vtkPolyData> OutputRounding::InputOfRun(
  vtkPolyData* input, const std::string& array) const
{
  if (this->Rounding == 0.0 || array.empty())
  {
    return input;
  }
  if (this->WritesSingle && !this->IsSingle && HasZeroTolerance(input, array))
  {
    Reject(this->Path,
      "single precision in " + this->Unit.Name + " would move points of tolerance 0; " +
        ExtensionsThat(&SurfaceFormat::HoldsDoubles) + " hold double precision");
  }
  return TolerancesBeforeRounding(input, array, this->Rounding);
}

//------------------------------------------------------------------------------
void OutputRounding::Apply(vtkPolyData* result, vtkBoneDecimate* filter)
{
  this->Result = result;
  if (filter->GetOutputPointsGrid() > 0.0)
  {
    this->ApplyGrid(filter);
  }
  this->InFile = FromMillimeters(this->Result, this->Unit, this->WritesSingle, this->InputInFile);
  if (this->Rounding == 0.0)
  {
    return;
  }
  const RoundedResult rounded = RoundForFile(this->Result, this->InFile,
    { this->Unit, this->Error, filter->GetErrorBoundArrayName(), filter->GetMergePoints(),
      this->Path });
  this->Move = rounded.Move;
  this->Result = rounded.Result;
  this->InFile = FromMillimeters(this->Result, this->Unit, this->WritesSingle, this->InputInFile);
  this->Notes.push_back("coordinates in " + this->Unit.Name + " are rounded by up to " +
    UpperBoundText(this->Move, 9) + " mm, which the largest error includes");
}

void OutputRounding::ApplyGrid(vtkBoneDecimate* filter)
{
  const double step = filter->GetOutputPointsGrid();
  const bool isProved = !filter->GetReportText("proof.status").empty();
  this->Notes.push_back(GridNote(step, isProved));
  this->Warnings = GridWarnings(this->Result, step, filter->GetMergePoints() && !isProved);
  if (this->Requested.ColorsErrors)
  {
    this->Result = WithErrorColors(this->Result,
      { filter->GetErrorBoundArrayName(), filter->GetDistanceArrayName() },
      ReportFields(this->Result).Number("proof.tolerance").value_or(0.0));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> OutputRounding::HeatmapOf(
  vtkBoneDecimate* filter, vtkPolyData* input) const
{
  if (this->Requested.Unit.IsMillimeter())
  {
    return filter->GetOutput(1);
  }
  const vtkSmartPointer<vtkPolyData> heatmap = FromMillimeters(
    WithWidenedBounds(filter->GetOutput(1), filter->GetInputErrorBoundArrayName(), this->Move),
    this->Requested.Unit, this->IsSingle, this->InputInFile);
  const std::string array = filter->GetToleranceArrayName();
  if (!array.empty())
  {
    heatmap->GetPointData()->AddArray(input->GetPointData()->GetArray(array.c_str()));
  }
  return heatmap;
}
}
