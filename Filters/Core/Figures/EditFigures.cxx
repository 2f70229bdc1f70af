// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EditFigures.h"

#include <algorithm>

namespace bonedecimate
{
void EditFigures::Add(const EditFigures& ofPart)
{
  this->Collapses += ofPart.Collapses;
  for (std::size_t i = 0; i < NumberOfRejections; ++i)
  {
    this->Rejections[i] += ofPart.Rejections[i];
  }
  this->Draft.Status = std::max(this->Draft.Status, ofPart.Draft.Status);
  this->Draft.Collapses += ofPart.Draft.Collapses;
  this->Draft.Undone += ofPart.Draft.Undone;
  this->Forced.Tried += ofPart.Forced.Tried;
  this->Forced.Made += ofPart.Forced.Made;
}
}
