// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExplainBound.h
 * @brief The bound of a run at each point, and how it is derived.
 */
#ifndef BoneDecimate_Applications_ExplainBound_h
#define BoneDecimate_Applications_ExplainBound_h

#include "Arguments/Arguments.h"
#include "Explain/Explanation.h"

#include "vtkPolyData.h"

namespace bonedecimate
{
/// @param surface mm; null: not known before the volume is read.
/// @param inFile The surface in the unit of its file.
/// @param voxelSize mm, of the volume; 0: not known.
/// @throws Failure as the run.
struct BoundSubject
{
  vtkPolyData* Surface;
  vtkPolyData* InFile;
  double VoxelSize;
  bool MayBeCoarser = false; ///< If the labels are those of a neural network's grid.
};

/// @return The options of the run, with the largest error that it keeps.
Options ExplainBound(
  const Arguments& arguments, const BoundSubject& subject, Explanation& explanation);
}

#endif
