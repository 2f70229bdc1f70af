// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HandleLimit.h
 * @brief Whether the handles of a surface prevent further collapses.
 *
 * A handle needs at least three edges around it and three through it. Where handles are many, most
 * edges connect two vertices of such a loop: their collapse would close a handle or pinch the
 * surface.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_HandleLimit_h
#define BoneDecimate_Core_Decimate_Stages_HandleLimit_h

#include "Decimate/Edit/Editor.h"

namespace bonedecimate
{
/// Whether the surface has handles, and the collapse of at least half of its edges would change the
/// topology. False for a surface with non-manifold points or labels, whose handles are not counted.
bool AreHandlesInTheWay(const Editor& editor);
}

#endif
