// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointChoice.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkExtractSelection.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStaticPointLocator.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Name of vtkExtractSelection's array when it preserves the topology: 1 where something is
/// selected.
const char* const InsideName = "vtkInsidedness";

bool IsPositive(double value)
{
  return value > 0.0;
}
}

PointChoice ChoosePoints(vtkDataArray* values, const Counts& counts, bool inverted)
{
  PointChoice choice;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    choice.push_back(counts(values->GetComponent(i, 0)) != inverted);
  }
  return choice;
}

//------------------------------------------------------------------------------
PointChoice ChooseCells(
  vtkPolyData* surface, vtkDataArray* values, const Counts& counts, bool inverted)
{
  PointChoice choice(static_cast<std::size_t>(surface->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (counts(values->GetComponent(cell, 0)) != inverted)
    {
      surface->GetCellPoints(cell, corners);
      for (const vtkIdType corner : *corners)
      {
        choice[static_cast<std::size_t>(corner)] = true;
      }
    }
  }
  return choice;
}

//------------------------------------------------------------------------------
PointChoice ChooseBySelection(vtkPolyData* surface, vtkSelection* selection, bool inverted)
{
  vtkNew<vtkExtractSelection> extract;
  extract->SetInputData(0, surface);
  extract->SetInputData(1, selection);
  extract->PreserveTopologyOn();
  extract->Update();
  vtkDataSet* selected = vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  if (!selected)
  {
    return PointChoice(static_cast<std::size_t>(surface->GetNumberOfPoints()), inverted);
  }
  vtkDataArray* cells = selected->GetCellData()->GetArray(InsideName);
  vtkDataArray* points = selected->GetPointData()->GetArray(InsideName);
  const bool ofCells = cells != nullptr && selection->GetNumberOfNodes() > 0 &&
    selection->GetNode(0)->GetFieldType() == vtkSelectionNode::CELL;
  if (ofCells)
  {
    return ChooseCells(surface, cells, IsPositive, inverted);
  }
  return points != nullptr
    ? ChoosePoints(points, IsPositive, inverted)
    : PointChoice(static_cast<std::size_t>(surface->GetNumberOfPoints()), inverted);
}

//------------------------------------------------------------------------------
std::vector<double> DistancesToChosen(vtkPolyData* surface, const PointChoice& choice, double most)
{
  std::vector<double> distances(choice.size(), most);
  vtkNew<vtkPoints> chosen;
  chosen->SetDataTypeToDouble();
  for (std::size_t i = 0; i < choice.size(); ++i)
  {
    if (choice[i])
    {
      chosen->InsertNextPoint(surface->GetPoint(static_cast<vtkIdType>(i)));
    }
  }
  if (chosen->GetNumberOfPoints() == 0)
  {
    return distances;
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(chosen);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  for (std::size_t i = 0; i < choice.size(); ++i)
  {
    double squared = 0.0; // mm^2
    const bool isNear = choice[i] ||
      locator->FindClosestPointWithinRadius(
        most, surface->GetPoint(static_cast<vtkIdType>(i)), squared) >= 0;
    distances[i] = isNear ? std::sqrt(squared) : most;
  }
  return distances;
}
}
