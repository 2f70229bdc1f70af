// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointChoice.h
 * @brief Points of a polydata that are chosen, by themselves or as corners of cells, and how far
 * the others are from them.
 */
#ifndef PointChoice_h
#define PointChoice_h

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkSelection;

namespace bonedecimate
{
/// For each point, whether it is chosen.
using PointChoice = std::vector<bool>;

/// Whether a value of an array counts.
using Counts = std::function<bool(double)>;

PointChoice ChoosePoints(vtkDataArray* values, const Counts& counts, bool inverted);

/// The corners of the cells that are chosen.
PointChoice ChooseCells(
  vtkPolyData* surface, vtkDataArray* values, const Counts& counts, bool inverted);

/// Chooses by points if the selection names points, else by cells.
PointChoice ChooseBySelection(vtkPolyData* surface, vtkSelection* selection, bool inverted);

/// mm, in a straight line from each point to the nearest that is chosen; `most` where that is
/// farther.
std::vector<double> DistancesToChosen(vtkPolyData* surface, const PointChoice& choice, double most);
}

#endif
