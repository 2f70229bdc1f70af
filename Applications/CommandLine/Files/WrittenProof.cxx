// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WrittenProof.h"

#include "ExitCode.h"
#include "Figures/BoundText.h"
#include "FileNames.h"
#include "PointPosition.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <vector>

namespace bonedecimate
{
namespace
{
void Certify(const ProvedRun& run, vtkPolyData* readBack, const std::string& target)
{
  vtkNew<vtkBoneSurfaceDistance> distance;
  distance->SetInputData(0, run.Input);
  distance->SetInputData(1, readBack);
  if (run.Tolerance > 0.0)
  {
    distance->SetTolerance(run.Tolerance);
  }
  distance->SetToleranceArrayName(run.ToleranceArray);
  distance->SetTightBounds(false);
  distance->SetMeasureBoundaries(run.WithBoundaries);
  distance->SetMeasureMeans(false);
  distance->SetSignedDistanceArrayName({});
  distance->SetNumberOfThreads(run.NumberOfThreads);
  distance->Update();
  if (distance->GetStatus() != vtkBoneSurfaceDistance::PROVED)
  {
    const bool isViolated = distance->GetStatus() == vtkBoneSurfaceDistance::VIOLATED;
    throw Failure(isViolated ? ExitCode::Violated : ExitCode::Undecided,
      "the certificate of '" + BaseName(target) + "' as it was read back " +
        (isViolated ? "contradicts" : "cannot decide") + " the largest error of " +
        (run.Tolerance > 0.0 ? FixedText(run.Tolerance, DecimalsOfRounding) + " mm" : "the map") +
        ": the distance is between " +
        LowerBoundText(distance->GetLowerBound(), DecimalsOfRounding) + " and " +
        UpperBoundText(distance->GetUpperBound(), DecimalsOfRounding) + " mm; nothing was written");
  }
}
}

namespace
{
using Corners = std::array<std::array<double, 3>, 3>;

/// In an order that does not depend on the file: each triangle from its least corner, the least
/// triangle first.
std::vector<Corners> SortedTriangles(vtkPolyData* surface)
{
  std::vector<Corners> triangles;
  const auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    if (size != 3)
    {
      return {};
    }
    Corners positions = { PositionOf(surface, corners[0]), PositionOf(surface, corners[1]),
      PositionOf(surface, corners[2]) };
    std::rotate(
      positions.begin(), std::min_element(positions.begin(), positions.end()), positions.end());
    triangles.push_back(positions);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

bool HasSameSequence(vtkPolyData* a, vtkPolyData* b)
{
  const auto cellsA = vtk::TakeSmartPointer(a->GetPolys()->NewIterator());
  const auto cellsB = vtk::TakeSmartPointer(b->GetPolys()->NewIterator());
  for (cellsA->GoToFirstCell(), cellsB->GoToFirstCell();
       !cellsA->IsDoneWithTraversal() && !cellsB->IsDoneWithTraversal();
       cellsA->GoToNextCell(), cellsB->GoToNextCell())
  {
    vtkIdType sizeA = 0;
    vtkIdType sizeB = 0;
    const vtkIdType* cornersA = nullptr;
    const vtkIdType* cornersB = nullptr;
    cellsA->GetCurrentCell(sizeA, cornersA);
    cellsB->GetCurrentCell(sizeB, cornersB);
    const bool isSame = sizeA == sizeB &&
      std::equal(cornersA, cornersA + sizeA, cornersB,
        [a, b](vtkIdType p, vtkIdType q) { return PositionOf(a, p) == PositionOf(b, q); });
    if (!isSame)
    {
      return false;
    }
  }
  return cellsA->IsDoneWithTraversal() && cellsB->IsDoneWithTraversal();
}
}

bool HasSameTriangles(vtkPolyData* a, vtkPolyData* b)
{
  if (HasSameSequence(a, b))
  {
    return true;
  }
  const std::vector<Corners> triangles = SortedTriangles(a);
  return !triangles.empty() && triangles == SortedTriangles(b);
}

void RequireSameTriangles(vtkPolyData* proved, vtkPolyData* readBack, const std::string& target)
{
  if (!HasSameTriangles(proved, readBack))
  {
    throw Failure(ExitCode::Undecided,
      "'" + BaseName(target) +
        "' as it was read back has other coordinates than those that were proved; nothing was "
        "written");
  }
}

void RequireProof(const std::string& status, const std::string& input, const std::string& message)
{
  if (status == "violated" || status == "undecided")
  {
    throw Failure(status == "violated" ? ExitCode::Violated : ExitCode::Undecided,
      "'" + BaseName(input) + "': " + message + "; nothing was written");
  }
}

std::string ProveWritten(const ProvedRun& run, vtkPolyData* readBack, const std::string& target)
{
  if (HasSameTriangles(run.Output, readBack))
  {
    return "same_bits";
  }
  Certify(run, readBack, target);
  return "certified";
}
}
