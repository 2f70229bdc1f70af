// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedPositions.h
 * @brief Where surfaces of different processes meet: points of open boundaries with exactly equal coordinates.
 */
#ifndef SharedPositions_h
#define SharedPositions_h

#include <array>
#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace bonedecimate
{
/// mm
using Position = std::array<double, 3>;

/// In ascending order, each once.
using Positions = std::vector<Position>;

/// The points of edges with one triangle, after equal points were merged.
Positions BoundaryPositions(vtkPolyData* surface);

/// The positions that more than one process has. Every process must call this, and all get the same result.
Positions SharedPositions(const Positions& own, vtkMultiProcessController* controller);

bool Contains(const Positions& positions, const double point[3]);
}

#endif
