// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Interruption.h
 * @brief An interruption by the user or the system as a flag that long work tests now and then.
 */
#ifndef BoneDecimate_Applications_Interruption_h
#define BoneDecimate_Applications_Interruption_h

namespace bonedecimate
{
/// From now on SIGINT, SIGTERM and SIGHUP (a closed terminal), on Windows events of the console,
/// are only noted; SIGHUP stays ignored where it was, as under nohup. A full disk or a closed pipe
/// is an error of the write, not a death.
void CatchSignals();

bool IsInterrupted();

/// Throws Failure(ExitCode::Interrupted).
void StopIfInterrupted();
}

#endif
