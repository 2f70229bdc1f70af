// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapOfRun.h"

#include "LabelMapArrays.h"
#include "Labels/LabelMap/EnclosedLabel.h"
#include "Labels/LabelMap/LabelRanks.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Run/Input/VoxelGridSearch.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The grid of a binary surface, with as many voxels as it reaches over.
std::optional<LabelMapSource> FindGridOf(const Surface& surface)
{
  std::optional<LabelMapSource> found = FindVoxelGrid(surface);
  for (std::size_t axis = 0; found && axis < 3; ++axis)
  {
    const auto largest = std::max_element(found->OfPoint.begin(), found->OfPoint.end(),
      [axis](const GridPoint& a, const GridPoint& b) { return a[axis] < b[axis]; });
    found->Grid.Dimensions[axis] = (*largest)[axis] / 2 + 2;
  }
  return found;
}

class LabelMapReading
{
public:
  LabelMapReading(const ConvertedSurface& converted, const Options& options)
    : Converted(converted)
    , Requested(options)
  {
  }

  LabelMapOfRun Go(vtkPolyData* input, const LabelMapRequest& request)
  {
    ReadLabelMap arrays = ReadLabelMapArrays(input, this->Converted);
    this->Read.Source = std::move(arrays.Source);
    this->Read.Problem = arrays.Problem;
    const bool isReadable =
      this->Read.Problem.empty() && !this->Converted.Surface.Triangles.empty();
    if (isReadable && request.Map != nullptr)
    {
      this->ReadMap(request);
    }
    else if (isReadable && request.Label != 0)
    {
      this->Read.Problem = "Label has no effect without a label map";
    }
    else if (isReadable && this->Read.Known() == nullptr &&
      this->Requested.KeepVoxels == KeepVoxels::On)
    {
      this->Read.Source = FindGridOf(this->Converted.Surface).value_or(LabelMapSource());
    }
    if (this->Read.Problem.empty() && isReadable)
    {
      this->CheckSmoothing(request.Map != nullptr);
    }
    return std::move(this->Read);
  }

private:
  void ReadMap(const LabelMapRequest& request)
  {
    LabelMapSource& source = this->Read.Source;
    this->Read.Image = ReadActiveLabels(request.Map);
    this->Read.Problem = this->Read.Image.Problem;
    if (this->Read.Problem.empty() && this->Read.Known() != nullptr)
    {
      ModelLabels onGrid =
        FindLabelsOnGrid(this->Read.Image, source.Grid, this->Requested.NumberOfThreads);
      this->Read.Problem =
        onGrid.AreFound() ? "" : "the voxel grid of the surface is not that of the label map";
      this->Read.Image = std::move(onGrid.Labels);
    }
    const VoxelGrid& grid = this->Read.Image.Image.Grid;
    if (this->Read.Problem.empty())
    {
      source.Grid = grid;
      this->FindLabel(request.Label);
    }
    if (this->Read.Problem.empty() && source.OfPoint.empty())
    {
      source.OfPoint =
        FindGridPoints(this->Converted.Surface, grid).value_or(std::vector<GridPoint>());
    }
  }

  void FindLabel(std::int64_t label)
  {
    LabelMapSource& source = this->Read.Source;
    if (!source.OfTriangle.empty())
    {
      this->Read.Problem = label == 0
        ? std::string()
        : "Label has no effect on a surface with the array " + std::string(BoundaryLabelsName);
      return;
    }
    const LabelValues values =
      FindLabelValues(this->Read.Image.Image, this->Requested.NumberOfThreads, {});
    const EnclosedLabel enclosed = FindEnclosedLabel(values.Values, label, 0);
    this->Read.Problem = enclosed.Problem;
    source.Values = { enclosed.Label, 0 };
  }

  /// Smoothing would change voxels at points whose position in the grid is not known.
  void CheckSmoothing(bool hasMap)
  {
    const Options& options = this->Requested;
    const bool isUnknown = this->Read.Known() != nullptr && this->Read.Source.OfPoint.empty();
    const bool isByGrid = hasMap && options.Smoothing == 0.0;
    if (isUnknown && options.Smooths() && (options.KeepVoxels == KeepVoxels::On || isByGrid))
    {
      this->Read.Problem = "smoothing can keep voxels only of a surface as it was extracted: there "
                           "are points that are "
                           "not the middle of an edge between two voxels of the grid";
    }
  }

  const ConvertedSurface& Converted;
  const Options& Requested;
  LabelMapOfRun Read;
};
}

//------------------------------------------------------------------------------
std::vector<std::string> LabelMapOfRun::CompareWithMap(
  const Surface& input, const Options& options, Result& result) const
{
  VoxelReport& report = result.Report.Voxels;
  if (this->Image.Image.Labels == nullptr || !report.WasChecked)
  {
    return {};
  }
  VoxelCheckSettings settings;
  settings.Grid = this->Source.Grid;
  settings.NumberOfLabels = static_cast<Index>(this->Source.Values.size());
  settings.Threads = options.NumberOfThreads;
  const auto compare = [&](const LabeledSurface& surface)
  { return CompareVoxels(this->Image.Image, this->Source.Values, surface, settings); };
  const bool isAsInput = report.Changes.Changed == 0;
  report.Changes = compare({ result.Surface, result.BoundaryLabels });
  report.Values = this->Source.Values;
  const VoxelChanges ofInput =
    isAsInput ? report.Changes : compare({ input, this->Source.OfTriangle });
  return ofInput.Changed == 0
    ? std::vector<std::string>()
    : std::vector<std::string>{ "the input itself gives " + std::to_string(ofInput.Changed) +
        " of the voxels another label than the label map: it is not the surface of this map and "
        "label, "
        "or was changed before" };
}

//------------------------------------------------------------------------------
LabelMapOfRun ReadLabelMapOfRun(vtkPolyData* input, const ConvertedSurface& converted,
  const LabelMapRequest& request, const Options& options)
{
  return LabelMapReading(converted, options).Go(input, request);
}

//------------------------------------------------------------------------------
void CopyLabelMapFields(vtkPolyData* input, vtkPolyData* output)
{
  for (const char* name : { GridOriginName, GridSpacingName, GridDirectionName, GridDimensionsName,
         GridLayersName, LabelValuesName, "LabelNames", "LabelColors" })
  {
    vtkAbstractArray* array = input->GetFieldData()->GetAbstractArray(name);
    if (array)
    {
      output->GetFieldData()->AddArray(array);
    }
  }
}
}
