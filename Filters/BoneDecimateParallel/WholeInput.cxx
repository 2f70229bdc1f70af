// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeInput.h"

#include "BoundaryStrips.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>

namespace bonedecimate
{
const char* const BlockArrayName = "BlockIndex";

namespace
{
/// Calls visit(block, flat index) for polydata with cells.
template <typename Visit>
void ForEachBlock(vtkCompositeDataSet* composite, const Visit& visit)
{
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkPolyData* block = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
    if (block && block->GetNumberOfCells() > 0)
    {
      visit(block, static_cast<int>(iterator->GetCurrentFlatIndex()));
    }
  }
}

vtkSmartPointer<vtkPolyData> AppendBlocks(vtkCompositeDataSet* composite)
{
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  ForEachBlock(composite,
    [&](vtkPolyData* block, int number)
    {
      vtkNew<vtkIntArray> index;
      index->SetName(BlockArrayName);
      index->SetNumberOfTuples(block->GetNumberOfCells());
      index->Fill(number);
      blocks.push_back(vtkSmartPointer<vtkPolyData>::New());
      blocks.back()->ShallowCopy(block);
      blocks.back()->GetCellData()->AddArray(index);
    });
  return Join(blocks);
}

vtkIdType CountOutOfRange(vtkCellArray* cells, vtkIdType points)
{
  vtkIdType found = 0;
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    const bool isWhole = std::all_of(
      corners, corners + size, [points](vtkIdType id) { return id >= 0 && id < points; });
    found += isWhole ? 0 : 1;
  }
  return found;
}
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> FilledParts(vtkDataObject* input)
{
  std::vector<vtkPolyData*> parts;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    ForEachBlock(composite, [&](vtkPolyData* block, int) { parts.push_back(block); });
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(input);
           surface && surface->GetNumberOfCells() > 0)
  {
    parts.push_back(surface);
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkIdType CellsOutOfRange(vtkDataObject* input)
{
  vtkIdType found = 0;
  for (vtkPolyData* part : FilledParts(input))
  {
    for (vtkCellArray* cells : { part->GetPolys(), part->GetStrips() })
    {
      found += CountOutOfRange(cells, part->GetNumberOfPoints());
    }
  }
  return found;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WholeInput(vtkDataObject* input)
{
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    whole = AppendBlocks(composite);
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    whole->ShallowCopy(surface);
  }
  whole->RemoveGhostCells();
  if (whole->GetNumberOfStrips() == 0 && whole->GetPolys()->GetMaxCellSize() <= 3)
  {
    return whole;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(whole);
  triangulate->Update();
  return triangulate->GetOutput();
}
}
