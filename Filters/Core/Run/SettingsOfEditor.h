// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SettingsOfEditor.h
 * @brief What the editor of a run keeps and guarantees, from options, inputs and mode.
 */
#ifndef BoneDecimate_Core_Run_SettingsOfEditor_h
#define BoneDecimate_Core_Run_SettingsOfEditor_h

#include "Decimate/Edit/EditorSettings.h"
#include "Run/Input/PrepareInput.h"

namespace bonedecimate
{
/// @param isAborted Whether what only edits need is left out.
EditorSettings SettingsOfEditor(const RunTask& task, const PreparedInput& prepared, bool isAborted);
}

#endif
