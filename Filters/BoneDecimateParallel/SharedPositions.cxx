// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedPositions.h"

#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
namespace
{
/// Zero has two signs, which compare equal but are not the same bytes.
Position PositionOf(const double point[3])
{
  return { point[0] + 0.0, point[1] + 0.0, point[2] + 0.0 };
}

void SortOnce(Positions& positions)
{
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
}
}

//------------------------------------------------------------------------------
Positions BoundaryPositions(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputData(surface);
  merge->SetTolerance(0.0);
  merge->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  vtkNew<vtkFeatureEdges> boundaries;
  boundaries->SetInputConnection(merge->GetOutputPort());
  boundaries->BoundaryEdgesOn();
  boundaries->FeatureEdgesOff();
  boundaries->NonManifoldEdgesOff();
  boundaries->ManifoldEdgesOff();
  boundaries->ColoringOff();
  boundaries->Update();
  vtkPolyData* found = boundaries->GetOutput();
  Positions positions;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    positions.push_back(PositionOf(found->GetPoint(i)));
  }
  SortOnce(positions);
  return positions;
}

//------------------------------------------------------------------------------
Positions SharedPositions(const Positions& own, vtkMultiProcessController* controller)
{
  const std::size_t processes = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const vtkIdType length = 3 * static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(processes, 0);
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(processes, 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  Positions all(static_cast<std::size_t>(offsets.back() + lengths.back()) / 3);
  // One number more, so that there is an address even where there is nothing to send.
  std::vector<double> sent(static_cast<std::size_t>(length) + 1, 0.0);
  std::vector<double> received(3 * all.size() + 1, 0.0);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    std::copy(own[i].begin(), own[i].end(), sent.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
  controller->AllGatherV(sent.data(), received.data(), length, lengths.data(), offsets.data());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = { received[3 * i], received[3 * i + 1], received[3 * i + 2] };
  }
  // Each process sent each of its positions once: what is there twice is shared.
  std::sort(all.begin(), all.end());
  Positions shared;
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    if (all[i] == all[i - 1])
    {
      shared.push_back(all[i]);
    }
  }
  SortOnce(shared);
  return shared;
}

//------------------------------------------------------------------------------
bool Contains(const Positions& positions, const double point[3])
{
  return std::binary_search(positions.begin(), positions.end(), PositionOf(point));
}
}
