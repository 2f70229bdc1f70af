// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeInput.h
 * @brief What a process has of a surface, as one polydata of triangles.
 */
#ifndef WholeInput_h
#define WholeInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace bonedecimate
{
/// Cell array of a composite input: the flat index of the block from which a cell came.
extern const char* const BlockArrayName;

/**
 * A polydata as it is, the polydata in a composite data set one after the other; without ghost
 * cells, which other processes have, and with polygons and strips as triangles if there are any.
 */
vtkSmartPointer<vtkPolyData> WholeInput(vtkDataObject* input);

/// Number of polygons and strips of all parts with a point id that no point has.
vtkIdType CellsOutOfRange(vtkDataObject* input);

/// The polydata, or those in a composite data set, that have cells.
std::vector<vtkPolyData*> FilledParts(vtkDataObject* input);
}

#endif
