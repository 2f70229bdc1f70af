// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelsPageFile.h"

#include "Formats/FileFrame.h"
#include "Page.h"
#include "Picture.h"
#include "Report/PageSurfaces.h"
#include "Terminal/VtkMessages.h"

namespace bonedecimate
{
namespace
{
constexpr const char* DistanceName = "DistanceOnPage"; // mm

PageLevel LevelAt(vtkBoneDecimateLevels* filter, vtkPolyData* input, int mark)
{
  filter->SetLevelError(0.0);
  filter->SetNumberOfTriangles(filter->GetMarkTriangles(mark));
  filter->Update();
  PageLevel level;
  level.Surface = WithDistances(filter->GetOutput(), input, DistanceName);
  level.MaxDistance = filter->GetMarkLargestDistance(mark);
  level.MeanDistance = filter->GetMarkMeanDistance(mark);
  return level;
}

/// The surface before and its coarsest level. @returns What went wrong, or an empty text.
std::string DrawLevels(const LevelsPageSubject& subject, const std::string& file)
{
  const auto before = WithDistances(subject.Before, subject.Levels.front().Surface, DistanceName);
  PictureSubject picture;
  picture.Before = before;
  picture.After = subject.Levels.front().Surface;
  picture.DistanceArrayName = DistanceName;
  picture.Title = subject.Name + ", coarsest level";
  picture.Frame = subject.Frame;
  TakeReport(picture);
  const std::string problem = WritePicture(picture, file);
  TakeVtkMessages(); // whatever VTK said about a missing display is in the problem
  return problem;
}
}

void WriteLevelsPage(vtkBoneDecimateLevels* filter, const std::string& name, StagedFile& page,
  std::vector<std::string>& warnings)
{
  LevelsPageSubject subject;
  subject.Name = name;
  subject.Before = vtkPolyData::SafeDownCast(filter->GetInput());
  for (int mark = filter->GetNumberOfMarks() - 1; mark >= 0; --mark)
  {
    subject.Levels.push_back(LevelAt(filter, subject.Before, mark));
  }
  subject.Report = filter->GetReportAsJson();
  subject.DistanceArrayName = DistanceName;
  subject.Reduce = ReduceForPage;
  subject.Frame = FrameOf(subject.Before);
  StagedFile picture(page.GetTarget() + ".png"); // never committed: the page holds it
  const std::string problem = DrawLevels(subject, picture.GetTemporary());
  if (problem.empty())
  {
    subject.PictureFile = picture.GetTemporary();
  }
  else
  {
    warnings.push_back("the picture could not be drawn: " + problem);
  }
  page.WriteText(ComposeLevelsPage(subject));
}
}
