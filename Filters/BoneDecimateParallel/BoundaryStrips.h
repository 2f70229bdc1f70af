// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryStrips.h
 * @brief The strips of triangles along the lines where surfaces of different processes meet.
 */
#ifndef BoundaryStrips_h
#define BoundaryStrips_h

#include "SharedPositions.h"

#include "vtkSmartPointer.h"

class vtkPoints;
class vtkPolyData;

namespace bonedecimate
{
struct StripParts
{
  vtkSmartPointer<vtkPolyData>
    Strip; ///< The triangles a few rings around the shared positions, with a mark of its rim.
  vtkSmartPointer<vtkPolyData> Rest; ///< Everything else. Both have the arrays of the surface.
};

StripParts CutStrips(vtkPolyData* surface, const Positions& shared);

/// Removes the mark of the rim: of each point of joined strips, whether they are connected to the rest there.
std::vector<char> TakeRim(vtkPolyData* strips);

/// One after the other, with the field data of the first that has points. Points are not merged.
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

/// mm, of each point to the nearest position of the surface; infinity if it has no cells.
std::vector<double> DistancesTo(vtkPolyData* surface, vtkPoints* points);
}

#endif
