// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnPlaces.h
 * @brief No two vertices where single precision knows one place only.
 *
 * Who reads the result takes points of equal coordinates for one. Two on one place would then close a slit in an open
 * border, however far its ends lie, and the border that was proved would not be the one that is read. So one of them goes
 * to a place next to it, by a move that is judged and proved like any other.
 */
#ifndef BoneDecimate_Core_Collapse_OwnPlaces_h
#define BoneDecimate_Core_Collapse_OwnPlaces_h

#include "Editor.h"

namespace bonedecimate
{
/// After the last other edit; nobody else may work meanwhile.
/// @param input Of which `clean` was made.
/// @param found Gets the points that could not be helped: then the status is not good.
InputStatus GiveOwnPlaces(
  Editor& editor, const Surface& input, const CleanSurface& clean, CleaningStatistics& found);
}

#endif
