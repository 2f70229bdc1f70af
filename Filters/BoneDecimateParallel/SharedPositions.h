// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedPositions.h
 * @brief Where surfaces of different processes meet: points with exactly equal coordinates.
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

/// Positions in ascending order, each once.
using Positions = std::vector<Position>;

/// The corners of the triangles.
Positions PositionsOf(vtkPolyData* surface);

/// The ends of edges where a part of a surface may end: of edges that have other than two
/// triangles, or two between different pairs of labels (cell array BoundaryLabels), after equal
/// points were merged. Every edge of a whole surface whose triangles are on several processes is
/// among them on one of these processes.
Positions CurvePositions(vtkPolyData* surface);

/// The curve positions of any process that triangles of more than one process have. Every process
/// must call this, and all get the same result.
Positions SharedPositions(vtkPolyData* surface, vtkMultiProcessController* controller);

bool Contains(const Positions& positions, const double point[3]);

/// Zero has two signs, which compare equal but are not the same bytes.
Position PositionOf(const double point[3]);

/// Brings them into order.
void SortOnce(Positions& positions);
}

#endif
