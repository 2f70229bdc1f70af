// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terminal/Interruption.h"

#include <atomic>
#include <windows.h>

namespace bonedecimate
{
namespace
{
std::atomic<bool> Interrupted{ false };

/// Called in a thread of its own.
BOOL WINAPI NoteInterruption(DWORD event)
{
  Interrupted = true;
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT)
  {
    // When it returns the process ends; until then there are a few seconds to put things in order.
    Sleep(INFINITE);
  }
  return TRUE;
}
}

void CatchSignals()
{
  SetConsoleCtrlHandler(NoteInterruption, TRUE);
}

bool IsInterrupted()
{
  return Interrupted;
}
}
