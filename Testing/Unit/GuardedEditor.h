// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GuardedEditor.h
 * @brief Settings of an editor with an error bound and the intersection guard.
 */
#ifndef BoneDecimate_Testing_GuardedEditor_h
#define BoneDecimate_Testing_GuardedEditor_h

#include "Decimate/Edit/Editor.h"

namespace bonedecimate::testsupport
{
/// @param error mm
inline EditorSettings Guarded(double error)
{
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.KeepsAreas = false;
  settings.KeepsQuadrics = true;
  settings.GuardsIntersections = true;
  settings.Bound = ErrorBoundSettings{ error };
  return settings;
}
}

#endif
