// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pruning.cxx
 * @brief vtkPBoneDecimate removes small components of the whole surface, as if they had never been in the input.
 */
#include "BoundaryStrips.h"
#include "Gathering.h"
#include "vtkPBoneDecimate.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <limits>

bool vtkPBoneDecimate::Prunes()
{
  return this->GetPruneSize() > 0.0 || this->GetPruneArea() > 0.0 || this->GetPruneVolume() > 0.0 ||
    this->GetPruneTriangles() > 0;
}

//------------------------------------------------------------------------------
/// What is left of this process's part. Null if nothing of any is; the reason has been reported.
vtkSmartPointer<vtkPolyData> vtkPBoneDecimate::PruneTogether(vtkPolyData* input)
{
  if (!this->Prunes())
  {
    return input;
  }
  const bool isEmpty = input->GetNumberOfPoints() == 0;
  std::array<double, 3> low = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double none = std::numeric_limits<double>::infinity();
    low[static_cast<std::size_t>(axis)] =
      this->OfAll(isEmpty ? none : input->GetBounds()[2 * axis], vtkCommunicator::MIN_OP);
  }
  std::vector<bool> pruned;
  const bool isAnyLeft = this->FindPrunedCells(
    input, bonedecimate::SharedPositions(input, this->Controller), low,
    [this](const Numbers& own) { return bonedecimate::AllNumbers(own, this->Controller); },
    this->Controller->GetLocalProcessId(), pruned);
  return isAnyLeft ? bonedecimate::WithoutCells(input, pruned) : nullptr;
}
