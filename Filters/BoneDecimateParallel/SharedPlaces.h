// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedPlaces.h
 * @brief Where surfaces of different processes meet: points of open borders with exactly equal coordinates.
 */
#ifndef SharedPlaces_h
#define SharedPlaces_h

#include <array>
#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace bonedecimate
{
/// mm
using Place = std::array<double, 3>;

/// In ascending order, each once.
using Places = std::vector<Place>;

/// The points of edges with one triangle, after equal points were merged.
Places BorderPlaces(vtkPolyData* surface);

/// The places that more than one process has. Every process must call this, and all get the same answer.
Places SharedPlaces(const Places& own, vtkMultiProcessController* controller);

bool Contains(const Places& places, const double point[3]);
}

#endif
