// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentSurfaces.h"

#include "Arguments/LabelMapArguments.h"
#include "Formats/FileChecks.h"
#include "LabelMapArrays.h"
#include "Labels/ModelGrid/ModelGridChoice.h"
#include "LeftOutOfReader.h"
#include "NamedLabels.h"
#include "Runs/FilterRun.h"
#include "SegmentChoice.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkBoneSurfaces.h"
#include "vtkBoneVoxelCheck.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

namespace bonedecimate
{
namespace
{
/// Replaces the map by that of the network from which it was copied.
void UseModelGrid(const Arguments& arguments, SegmentSurfaces& segments)
{
  ModelGridChoice choice = ReadModelGridChoice(arguments.ModelGrid);
  if (!choice.Request || arguments.Memory > 0) // slabs are those of the file
  {
    return;
  }
  choice.Request->Threads = arguments.Options.NumberOfThreads;
  segments.Model = FindModelLabels(ReadActiveLabels(segments.Map), *choice.Request);
  if (segments.Model.AreFound())
  {
    segments.MapOfFile = segments.Map;
    segments.Map = MakeModelImage(segments.Map, segments.Model);
  }
  else if (choice.IsRequired())
  {
    Reject(arguments.Inputs[0], NoModelGridReason);
  }
}

/// The surface of the labels of a map, on the map's own grid.
vtkSmartPointer<vtkPolyData> Extract(vtkImageData* map, const std::vector<std::int64_t>& labels,
  const Arguments& arguments, std::vector<std::string>& warnings)
{
  vtkNew<vtkBoneSurfaces> extraction;
  extraction->SetInputData(map);
  extraction->SetModelGrid("off");
  extraction->SetNumberOfThreads(arguments.Options.NumberOfThreads);
  for (const std::int64_t label : labels)
  {
    extraction->AddLabel(label);
  }
  AcceptMessages(UpdateFilter(extraction, Progress::Hidden), arguments.Inputs[0], warnings);
  return extraction->GetOutput();
}

/// mm, proved, at most a hundredth above the largest distance.
double ProvedDistanceOf(vtkPolyData* reference, vtkPolyData* surface, const Arguments& arguments,
  std::vector<std::string>& warnings)
{
  constexpr double gap = 0.01;
  vtkNew<vtkBoneSurfaceDistance> distance;
  distance->SetInputData(0, reference);
  distance->SetInputData(1, surface);
  distance->SetRelativeGap(gap);
  distance->SetMeasureBoundaries(false);
  distance->SetMeasureMeans(false);
  distance->SetSignedDistanceArrayName({});
  distance->SetNumberOfThreads(arguments.Options.NumberOfThreads);
  AcceptMessages(UpdateFilter(distance, Progress::Hidden), arguments.Inputs[0], warnings);
  return distance->GetUpperBound();
}
}

SegmentSurfaces ExtractSegments(const Arguments& arguments, std::vector<std::string>& warnings)
{
  const std::string& path = arguments.Inputs[0];
  SegmentSurfaces segments;
  segments.Map = ReadLabels(
    path, warnings, arguments.LabelMap.GetSpacing(), SelectionOf(arguments.Segments, path));
  const FoundSegments found = FindSegments(segments.Map, arguments.Segments, path);
  const std::vector<NamedLabel> chosen = ChooseSegments(found, arguments.Segments, path, warnings);
  segments.Note = found.Note;
  WriteNamedLabels(found.Present, segments.Map->GetFieldData());
  UseModelGrid(arguments, segments);
  segments.Map = ChangePieces(segments.Map, chosen, arguments, segments.Changed, warnings);
  for (const NamedLabel& label : chosen)
  {
    segments.Chosen.push_back(label.Value);
  }
  segments.Surface = Extract(segments.Map, segments.Chosen, arguments, warnings);
  for (const LeftOut& entry : SegmentsLeftOut(found, arguments.Segments, chosen))
  {
    AddLeftOutOfReader(entry, segments.Surface);
  }
  return segments;
}

FileComparison CompareWithMapOfFile(vtkPolyData* surface, const SegmentSurfaces& segments,
  const Arguments& arguments, std::vector<std::string>& warnings)
{
  vtkNew<vtkPolyData> withoutGrid; // whose voxels are not those of the file
  withoutGrid->ShallowCopy(surface);
  withoutGrid->GetFieldData()->RemoveArray(GridDimensionsName);
  vtkNew<vtkBoneVoxelCheck> check;
  check->SetInputData(0, withoutGrid);
  check->SetInputData(1, segments.MapOfFile);
  check->SetNumberOfThreads(arguments.Options.NumberOfThreads);
  AcceptMessages(UpdateFilter(check, Progress::Hidden), arguments.Inputs[0], warnings);
  const auto ofFile = Extract(segments.MapOfFile, segments.Chosen, arguments, warnings);
  return { check->GetNumberOfComparedVoxels(), check->GetNumberOfChangedVoxels(),
    ProvedDistanceOf(ofFile, surface, arguments, warnings) };
}

vtkSmartPointer<vtkPolyData> WithColorArray(vtkPolyData* surface)
{
  const auto colors = ColorsOfTriangles(surface, LabelsOf(surface));
  if (!colors)
  {
    return surface;
  }
  auto colored = vtkSmartPointer<vtkPolyData>::New();
  colored->ShallowCopy(surface);
  colored->GetCellData()->AddArray(colors);
  return colored;
}
}
