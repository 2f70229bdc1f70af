// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Interruption.h
 * @brief SIGINT, SIGTERM and SIGHUP as a flag that long work tests now and then.
 */
#ifndef BoneDecimate_Applications_Interruption_h
#define BoneDecimate_Applications_Interruption_h

namespace bonedecimate
{
/// From now on SIGINT, SIGTERM and SIGHUP (a closed terminal) are only noted; SIGHUP stays ignored
/// where it was, as under nohup. A full disk or a closed pipe is an error of the
/// write, not a death.
void CatchSignals();

bool IsInterrupted();

/// Throws Failure(ExitCode::Interrupted).
void StopIfInterrupted();
}

#endif
