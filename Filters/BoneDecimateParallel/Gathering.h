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
/// The pieces of all processes on that process, one after the other in their order; null on others.
vtkSmartPointer<vtkPolyData> GatheredAt(
  int process, vtkPolyData* piece, vtkMultiProcessController* controller);

/// The pieces of all processes on every process, one after the other in their order.
vtkSmartPointer<vtkPolyData> GatheredEverywhere(
  vtkPolyData* piece, vtkMultiProcessController* controller);

/// The numbers of each process, on every process.
std::vector<std::vector<double>> AllNumbers(
  const std::vector<double>& own, vtkMultiProcessController* controller);
}

#endif
