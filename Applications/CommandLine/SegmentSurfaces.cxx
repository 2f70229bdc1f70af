// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentSurfaces.h"

#include "FilterRun.h"
#include "LabelMapArguments.h"
#include "LeftOutOfReader.h"
#include "NamedLabels.h"
#include "SegmentChoice.h"

#include "vtkBoneSurfaces.h"
#include "vtkCellData.h"
#include "vtkNew.h"

namespace bonedecimate
{
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
  segments.Map = ChangePieces(segments.Map, chosen, arguments, segments.Changed, warnings);
  vtkNew<vtkBoneSurfaces> extraction;
  extraction->SetInputData(segments.Map);
  extraction->SetNumberOfThreads(arguments.Options.NumberOfThreads);
  for (const NamedLabel& label : chosen)
  {
    extraction->AddLabel(label.Value);
  }
  AcceptMessages(UpdateFilter(extraction, Progress::Hidden), path, warnings);
  segments.Surface = extraction->GetOutput();
  for (const LeftOut& entry : SegmentsLeftOut(found, arguments.Segments, chosen))
  {
    AddLeftOutOfReader(entry, segments.Surface);
  }
  return segments;
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
