// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Gathering.h
 * @brief What all processes have: surfaces and numbers. Every process must call these.
 */
#ifndef Gathering_h
#define Gathering_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace bonedecimate
{
/// On that process the pieces of all processes, one after the other in their order; null on the others.
vtkSmartPointer<vtkPolyData> GatheredAt(
  int process, vtkPolyData* piece, vtkMultiProcessController* controller);

/// The same on every process.
vtkSmartPointer<vtkPolyData> GatheredEverywhere(
  vtkPolyData* piece, vtkMultiProcessController* controller);

/// Of each process its numbers, the same on every process.
std::vector<std::vector<double>> AllNumbers(
  const std::vector<double>& own, vtkMultiProcessController* controller);
}

#endif
