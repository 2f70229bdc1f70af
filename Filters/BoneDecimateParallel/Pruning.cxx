// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pruning.cxx
 * @brief What vtkPBoneDecimate does to its input first: labels of cells, and small components of
 * the whole surface are removed, as if they had never been in the input.
 */
#include "BoundaryStrips.h"
#include "DecimateInternals.h"
#include "Gathering.h"
#include "vtkPBoneDecimate.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <limits>

/// The input with the labels of its cells, if labels are chosen: points may have them, and lose
/// them when they move. Null if the array of a process does not suit; the reason has been reported.
vtkSmartPointer<vtkPolyData> vtkPBoneDecimate::WithCellLabels(vtkPolyData* input)
{
  if (!this->Internal->HasInputArray(LABEL_ARRAY))
  {
    return input;
  }
  auto labeled = vtkSmartPointer<vtkPolyData>::New();
  labeled->ShallowCopy(input);
  vtkSmartPointer<vtkDataArray> labels;
  if (input->GetNumberOfPoints() > 0)
  {
    labels = this->Internal->GetCellLabels(input);
  }
  const bool isWrong = input->GetNumberOfPoints() > 0 && !labels;
  if (this->IsTrueAnywhere(isWrong))
  {
    if (!isWrong)
    {
      vtkErrorMacro(<< "another process has no suitable array of labels");
    }
    return nullptr;
  }
  if (labels)
  {
    labels->SetName(bonedecimate::CellLabelsName);
    labeled->GetCellData()->AddArray(labels);
  }
  return labeled;
}

//------------------------------------------------------------------------------
/// How the parts of all processes become one surface. Every process must call this.
bonedecimate::MeetingOfParts vtkPBoneDecimate::MeetingOf(vtkPolyData* part) const
{
  bonedecimate::MeetingOfParts meeting;
  meeting.Shared = bonedecimate::SharedPositions(part, this->Controller);
  const bool isEmpty = part->GetNumberOfPoints() == 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double none = std::numeric_limits<double>::infinity();
    meeting.Origin[static_cast<std::size_t>(axis)] =
      this->OfAll(isEmpty ? none : part->GetBounds()[2 * axis], vtkCommunicator::MIN_OP);
  }
  meeting.Exchange = [this](const std::vector<double>& own)
  { return bonedecimate::AllNumbers(own, this->Controller); };
  meeting.Own = this->Controller->GetLocalProcessId();
  return meeting;
}

//------------------------------------------------------------------------------
/// What is left of this process's part. Null if nothing of any is; the reason has been reported.
vtkSmartPointer<vtkPolyData> vtkPBoneDecimate::PruneTogether(vtkPolyData* input)
{
  if (!this->Internal->Prunes())
  {
    return input;
  }
  std::vector<bool> pruned;
  const bool isAnyLeft = this->Internal->FindPrunedCells(input, this->MeetingOf(input), pruned);
  return isAnyLeft ? bonedecimate::WithoutCells(input, pruned) : nullptr;
}
