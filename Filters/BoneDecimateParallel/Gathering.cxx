// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gathering.h"

#include "BoundaryStrips.h"

#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <numeric>

namespace bonedecimate
{
vtkSmartPointer<vtkPolyData> GatheredAt(
  int process, vtkPolyData* piece, vtkMultiProcessController* controller)
{
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  controller->Gather(piece, received, process);
  if (controller->GetLocalProcessId() != process)
  {
    return nullptr;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  pieces.reserve(received.size());
  for (vtkDataObject* one : received)
  {
    pieces.emplace_back(vtkPolyData::SafeDownCast(one));
  }
  return Join(pieces);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> GatheredEverywhere(
  vtkPolyData* piece, vtkMultiProcessController* controller)
{
  vtkSmartPointer<vtkPolyData> all = GatheredAt(0, piece, controller);
  if (!all)
  {
    all = vtkSmartPointer<vtkPolyData>::New();
  }
  controller->Broadcast(all, 0);
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::vector<double>> AllNumbers(
  const std::vector<double>& own, vtkMultiProcessController* controller)
{
  const std::size_t processes = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const vtkIdType length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(processes, 0);
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(processes, 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  // One number more, so that there is an address even where there is nothing to send.
  std::vector<double> sent = own;
  sent.push_back(0.0);
  std::vector<double> received(static_cast<std::size_t>(offsets.back() + lengths.back()) + 1, 0.0);
  controller->AllGatherV(sent.data(), received.data(), length, lengths.data(), offsets.data());
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < processes; ++i)
  {
    const auto first = received.begin() + offsets[i];
    all.emplace_back(first, first + lengths[i]);
  }
  return all;
}
}
