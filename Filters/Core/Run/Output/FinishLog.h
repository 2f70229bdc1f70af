// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FinishLog.h
 * @brief Completes the log of a run: what identifies its input, and positions as they are written.
 */
#ifndef BoneDecimate_Core_Run_Output_FinishLog_h
#define BoneDecimate_Core_Run_Output_FinishLog_h

#include "Levels/EditLog.h"
#include "Run/Input/PrepareInput.h"

#include <cstdint>

namespace bonedecimate
{
/// @param log The log of the editor, positions in mm relative to the origin of the cleaned input.
/// @param mesh After the last edit.
/// @return The log with positions in mm as they are written.
EditLog FinishLog(EditLog log, const RunTask& task, const CleanSurface& cleaned,
  const HalfEdgeMesh& mesh, std::uint64_t inputChecksum);
}

#endif
