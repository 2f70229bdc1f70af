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
/// Point array of a strip: 0 where it is connected to the rest and must not change, -1 at other points.
extern const char* const RimArrayName;

struct StripParts
{
  vtkSmartPointer<vtkPolyData> Strip; ///< The triangles a few rings around the shared positions.
  vtkSmartPointer<vtkPolyData> Rest;  ///< Everything else. Both have the arrays of the surface.
};

StripParts CutStrips(vtkPolyData* surface, const Positions& shared);

/// One after the other. Points are not merged.
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

/// mm, of each point to the nearest position of the surface; infinity if it has no cells.
std::vector<double> DistancesTo(vtkPolyData* surface, vtkPoints* points);
}

#endif
