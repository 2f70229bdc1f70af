// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOutOfReader.h
 * @brief What the reader of a file left out of a surface.
 *
 * It is in the field array BoneDecimateLeftOut: four texts for each entry, its kind, count, noun
 * and where the first is (Figures/LeftOut.h). The report of a run takes them over, and the array
 * ends there.
 */
#ifndef LeftOutOfReader_h
#define LeftOutOfReader_h

#include "Figures/LeftOut.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace bonedecimate
{
/// Adds an entry, unless its count is 0; its distance is not known.
void AddLeftOutOfReader(const LeftOut& entry, vtkPolyData* surface);

std::vector<LeftOut> LeftOutOfReader(vtkPolyData* surface);

void RemoveLeftOutOfReader(vtkFieldData* fieldData);
}

#endif
