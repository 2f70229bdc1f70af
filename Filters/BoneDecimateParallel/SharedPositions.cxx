// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedPositions.h"

#include "Gathering.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <tuple>

namespace bonedecimate
{
namespace
{
struct EdgeOfCell
{
  vtkIdType Low; // point ids
  vtkIdType High;
  vtkIdType Cell;

  bool IsSameEdge(const EdgeOfCell& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const EdgeOfCell& other) const
  {
    return std::tie(this->Low, this->High, this->Cell) <
      std::tie(other.Low, other.High, other.Cell);
  }
};

/// The edges of all cells, sorted: equal edges follow each other.
std::vector<EdgeOfCell> EdgesOf(vtkPolyData* surface)
{
  std::vector<EdgeOfCell> edges;
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType from = corners[i];
      const vtkIdType to = corners[(i + 1) % size];
      edges.push_back({ std::min(from, to), std::max(from, to), cell });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool HaveSameLabels(vtkDataArray* labels, vtkIdType first, vtkIdType second)
{
  return !labels ||
    (labels->GetComponent(first, 0) == labels->GetComponent(second, 0) &&
      labels->GetComponent(first, 1) == labels->GetComponent(second, 1));
}

/// The positions of all processes.
Positions GatherAll(const Positions& own, vtkMultiProcessController* controller)
{
  std::vector<double> numbers;
  for (const Position& position : own)
  {
    numbers.insert(numbers.end(), position.begin(), position.end());
  }
  Positions all;
  for (const std::vector<double>& ofProcess : AllNumbers(numbers, controller))
  {
    for (std::size_t i = 0; i + 2 < ofProcess.size(); i += 3)
    {
      all.push_back({ ofProcess[i], ofProcess[i + 1], ofProcess[i + 2] });
    }
  }
  SortOnce(all);
  return all;
}
}

//------------------------------------------------------------------------------
Position PositionOf(const double point[3])
{
  return { point[0] + 0.0, point[1] + 0.0, point[2] + 0.0 };
}

void SortOnce(Positions& positions)
{
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
}

//------------------------------------------------------------------------------
Positions PositionsOf(vtkPolyData* surface)
{
  Positions positions;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      positions.push_back(PositionOf(surface->GetPoint(corners[i])));
    }
  }
  SortOnce(positions);
  return positions;
}

//------------------------------------------------------------------------------
Positions CurvePositions(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputData(surface);
  merge->SetTolerance(0.0);
  merge->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  merge->Update();
  vtkPolyData* merged = merge->GetOutput();
  vtkDataArray* labels = merged->GetCellData()->GetArray("BoundaryLabels");
  const std::vector<EdgeOfCell> edges = EdgesOf(merged);
  Positions positions;
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    while (next < edges.size() && edges[next].IsSameEdge(edges[first]))
    {
      ++next;
    }
    if (next - first != 2 || !HaveSameLabels(labels, edges[first].Cell, edges[first + 1].Cell))
    {
      positions.push_back(PositionOf(merged->GetPoint(edges[first].Low)));
      positions.push_back(PositionOf(merged->GetPoint(edges[first].High)));
    }
  }
  SortOnce(positions);
  return positions;
}

//------------------------------------------------------------------------------
Positions SharedPositions(vtkPolyData* surface, vtkMultiProcessController* controller)
{
  const Positions curves = GatherAll(CurvePositions(surface), controller);
  const Positions own = PositionsOf(surface);
  std::vector<int> isHere(curves.size() + 1, 0); // one more, so that there is an address
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    isHere[i] = std::binary_search(own.begin(), own.end(), curves[i]) ? 1 : 0;
  }
  std::vector<int> processes = isHere;
  controller->AllReduce(isHere.data(), processes.data(), static_cast<vtkIdType>(isHere.size()),
    vtkCommunicator::SUM_OP);
  Positions shared;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (processes[i] > 1)
    {
      shared.push_back(curves[i]);
    }
  }
  return shared;
}

//------------------------------------------------------------------------------
bool Contains(const Positions& positions, const double point[3])
{
  return std::binary_search(positions.begin(), positions.end(), PositionOf(point));
}
}
