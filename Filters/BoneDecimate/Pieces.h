// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pieces.h
 * @brief Which piece of the output of a filter is requested: each of several processes requests one
 * of its own.
 */
#ifndef Pieces_h
#define Pieces_h

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace bonedecimate
{
struct PieceOfOutput
{
  int Number = 0;
  int Pieces = 1; ///< How many there are.
};

inline PieceOfOutput RequestedPiece(vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  vtkInformationIntegerKey* number = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  vtkInformationIntegerKey* pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  return output->Has(number) && output->Has(pieces)
    ? PieceOfOutput{ output->Get(number), output->Get(pieces) }
    : PieceOfOutput{};
}
}

#endif
