// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The thesis's tables for our stand-ins, and the whole cranium, with vtkQuadricDecimation as the yardstick.
 *
 *     bonedecimate-benchmark VOLUME.mhd [ROUNDS]
 *
 * Prints Markdown. Seconds are medians over the rounds (3), the contestants in turn; distances are mm.
 */
#include "Bones.h"
#include "Contest.h"
#include "ThesisFigures.h"

#include "vtkObject.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{
constexpr int CraniumTriangles = 134000;

void PrintHead(const char* title)
{
  std::printf("\n### %s\n\n", title);
  std::printf("| asked for | who | triangles | points: max | second | average | RMS | area: max | "
              "average | RMS "
              "| back: max | average | RMS | components | non-manifold | s | MB |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void PrintOutcome(double asked, const char* who, const Outcome& outcome)
{
  const bonedecimate::DistanceStatistics& there = outcome.There;
  const bonedecimate::DistanceStatistics& back = outcome.Back;
  std::printf("| %g | %s | %lld | %.4f | %.4f | %.5f | %.5f | %.4f | %.5f | %.5f | %.4f | %.5f | "
              "%.5f | %lld | %lld | "
              "%.2f | %.0f |\n",
    asked, who, static_cast<long long>(outcome.Surface.Faces), there.PointMaximum, there.Second,
    there.PointMean, there.PointRootMeanSquare, there.Maximum, there.Mean, there.RootMeanSquare,
    back.Maximum, back.Mean, back.RootMeanSquare,
    static_cast<long long>(outcome.Surface.Components),
    static_cast<long long>(outcome.Surface.NonManifoldEdges), outcome.Seconds, outcome.Megabytes);
}

void PrintStandings(double asked, const Standings& standings)
{
  PrintOutcome(asked, "vtkBoneDecimate Thesis", standings.Thesis);
  PrintOutcome(asked, "vtkBoneDecimate Fast", standings.Fast);
  PrintOutcome(asked, "vtkQuadricDecimation", standings.Vtk);
  std::fflush(stdout);
}

/// "-" where the thesis printed nothing.
void PrintFigure(double value, const char* format)
{
  std::printf(" | ");
  if (value < 0.0)
  {
    std::printf("-");
  }
  else
  {
    std::printf(format, value);
  }
}

void PrintThesis(const ThesisRow& row)
{
  std::printf("| %g | thesis, its own mesh | %.0f", row.Asked, row.Faces);
  PrintFigure(row.Maximum, "%.4f");
  PrintFigure(row.Second, "%.4f");
  PrintFigure(row.Average, "%.5f");
  PrintFigure(row.RootMeanSquare, "%.5f");
  std::printf(" | - | - | - | - | - | - | - | -");
  PrintFigure(row.Seconds, "%.2f");
  std::printf(" | - |\n");
}

void PrintBone(const ThesisBone& thesis, vtkPolyData* bone, int rounds)
{
  char title[160];
  const long long triangles = bone->GetNumberOfPolys();
  std::snprintf(title, sizeof(title), "%s: %lld triangles (the thesis's had %d)", thesis.Name,
    triangles, thesis.Faces);
  PrintHead(title);
  for (const ThesisRow& row : thesis.ByCount)
  {
    PrintThesis(row);
    PrintStandings(row.Asked, ContestToCount(bone, static_cast<int>(row.Asked), rounds));
  }
  std::snprintf(
    title, sizeof(title), "%s, error mode: asked for a largest distance in mm", thesis.Name);
  PrintHead(title);
  for (const ThesisRow& row : thesis.ByError)
  {
    PrintThesis(row);
    PrintStandings(row.Asked, ContestToError(bone, row.Asked, rounds));
  }
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: bonedecimate-benchmark VOLUME.mhd [ROUNDS]\n");
    return EXIT_FAILURE;
  }
  vtkObject::GlobalWarningDisplayOff(); // the same few words about the bones in every round
  try
  {
    const Bones bones(argv[1]);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 3;
    PrintBone(ThesisMaxilla(), bones.LargestIn(Bones::Maxilla), rounds);
    PrintBone(ThesisFrontalBone(), bones.LargestIn(Bones::FrontalBone), rounds);
    const vtkSmartPointer<vtkPolyData> cranium = bones.Whole();
    PrintHead("whole volume");
    PrintStandings(CraniumTriangles, ContestToCount(cranium, CraniumTriangles, rounds));
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-benchmark: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
