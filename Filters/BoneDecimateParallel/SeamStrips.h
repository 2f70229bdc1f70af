// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SeamStrips.h
 * @brief The strips of triangles along the lines where surfaces of different processes meet.
 */
#ifndef SeamStrips_h
#define SeamStrips_h

#include "SharedPlaces.h"

#include "vtkSmartPointer.h"

class vtkPoints;
class vtkPolyData;

namespace bonedecimate
{
/// Point array of a strip: 0 where it hangs together with the rest, which must stay there, -1 elsewhere.
extern const char* const RimArrayName;

struct SeamParts
{
  vtkSmartPointer<vtkPolyData> Strip; ///< The triangles a few rings around the shared places.
  vtkSmartPointer<vtkPolyData> Rest;  ///< Everything else. Both have the arrays of the surface.
};

SeamParts CutSeams(vtkPolyData* surface, const Places& shared);

/// One after the other. Points are not merged.
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

/// mm, of each point to the nearest place of the surface; infinity if it has no cells.
std::vector<double> DistancesTo(vtkPolyData* surface, vtkPoints* points);
}

#endif
