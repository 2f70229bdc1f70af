// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Contest.h"

#include "Geometry/BoundingTree.h"
#include "Measure/SurfaceDistance.h"
#include "Mesh/Statistics.h"
#include "PeakMemory.h"
#include "vtkBoneDecimate.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkQuadricDecimation.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace
{
bonedecimate::Surface ToCore(vtkPolyData* polydata)
{
  bonedecimate::Surface surface;
  for (vtkIdType p = 0; p < polydata->GetNumberOfPoints(); ++p)
  {
    const double* x = polydata->GetPoint(p);
    surface.Points.emplace_back(x[0], x[1], x[2]);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < polydata->GetNumberOfPolys(); ++cell)
  {
    polydata->GetPolys()->GetCellAtId(cell, ids);
    surface.Triangles.push_back({ static_cast<bonedecimate::Index>(ids->GetId(0)),
      static_cast<bonedecimate::Index>(ids->GetId(1)),
      static_cast<bonedecimate::Index>(ids->GetId(2)) });
  }
  return surface;
}

/// Distances of `from` to `to`, over the points that its triangles use and over its area.
bonedecimate::DistanceStatistics Distance(
  const bonedecimate::Surface& from, const bonedecimate::BoundingTree& to)
{
  std::vector<char> used(from.Points.size(), 0);
  for (const bonedecimate::Triangle& corners : from.Triangles)
  {
    for (const bonedecimate::Index corner : corners)
    {
      used[static_cast<std::size_t>(corner)] = 1;
    }
  }
  std::vector<bonedecimate::Vector3> points;
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    if (used[p] != 0)
    {
      points.push_back(from.Points[p]);
    }
  }
  const bonedecimate::Monitor goOn = [](double) { return true; };
  const std::vector<double> distances = bonedecimate::PointDistances(points, to, 0, goOn);
  return bonedecimate::MeasureDistance(from, distances, to, 1000000, 0, goOn);
}

void Judge(vtkPolyData* bone, vtkPolyData* result, Outcome& outcome)
{
  const bonedecimate::Surface original = ToCore(bone);
  const bonedecimate::Surface simplified = ToCore(result);
  outcome.Surface = bonedecimate::Describe(simplified);
  outcome.There = Distance(simplified, bonedecimate::BoundingTree(original));
  outcome.Back = Distance(original, bonedecimate::BoundingTree(simplified));
}

/// Runs once and keeps seconds and memory.
void RunOnce(const std::function<void()>& run, std::vector<double>& seconds, Outcome& outcome)
{
  const PeakMemory memory;
  const auto start = std::chrono::steady_clock::now();
  run();
  seconds.push_back(
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  outcome.Megabytes = std::max(outcome.Megabytes, memory.Megabytes());
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One of our modes once; the first round's result is judged.
vtkSmartPointer<vtkPolyData> RunOurs(vtkPolyData* bone,
  const std::function<void(vtkBoneDecimate*)>& ask, std::vector<double>& seconds, Outcome& outcome)
{
  vtkNew<vtkBoneDecimate> ours;
  ours->SetInputData(bone);
  ours->MeasureDistancesOff();
  ask(ours);
  RunOnce([&] { ours->Update(); }, seconds, outcome);
  if (seconds.size() == 1)
  {
    Judge(bone, ours->GetOutput(), outcome);
  }
  return ours->GetOutput();
}

void RunVtk(vtkPolyData* bone, double reduction, std::vector<double>& seconds, Outcome& outcome)
{
  vtkNew<vtkQuadricDecimation> quadric;
  quadric->SetInputData(bone);
  quadric->SetTargetReduction(reduction);
  RunOnce([&] { quadric->Update(); }, seconds, outcome);
  if (seconds.size() == 1)
  {
    Judge(bone, quadric->GetOutput(), outcome);
  }
}

Standings Contest(
  vtkPolyData* bone, const std::function<void(vtkBoneDecimate*)>& askThesis, int rounds)
{
  Standings standings;
  std::vector<double> thesisSeconds;
  std::vector<double> fastSeconds;
  std::vector<double> vtkSeconds;
  for (int round = 0; round < rounds; ++round)
  {
    const vtkIdType triangles =
      RunOurs(bone, askThesis, thesisSeconds, standings.Thesis)->GetNumberOfPolys();
    const auto askFast = [&](vtkBoneDecimate* ours)
    {
      ours->SetModeToFast();
      ours->SetTargetNumberOfTriangles(static_cast<int>(triangles));
    };
    RunOurs(bone, askFast, fastSeconds, standings.Fast);
    const double kept =
      static_cast<double>(triangles) / static_cast<double>(bone->GetNumberOfPolys());
    RunVtk(bone, 1.0 - kept, vtkSeconds, standings.Vtk);
  }
  standings.Thesis.Seconds = Median(thesisSeconds);
  standings.Fast.Seconds = Median(fastSeconds);
  standings.Vtk.Seconds = Median(vtkSeconds);
  return standings;
}
}

Standings ContestToCount(vtkPolyData* bone, int triangles, int rounds)
{
  return Contest(
    bone, [&](vtkBoneDecimate* ours) { ours->SetTargetNumberOfTriangles(triangles); }, rounds);
}

Standings ContestToError(vtkPolyData* bone, double millimetres, int rounds)
{
  return Contest(
    bone, [&](vtkBoneDecimate* ours) { ours->SetMaximumError(millimetres); }, rounds);
}
