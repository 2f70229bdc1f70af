// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terminal/Interruption.h"

#include <csignal>

namespace bonedecimate
{
namespace
{
volatile std::sig_atomic_t Interrupted = 0;

extern "C" void NoteInterruption(int)
{
  Interrupted = 1;
}

void Handle(int signal, void (*handler)(int))
{
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

bool IsIgnored(int signal)
{
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

#ifdef __linux__
bool HangupWasIgnored = false;

extern "C" void NoteHangup(int, char**, char**)
{
  HangupWasIgnored = IsIgnored(SIGHUP);
}

/// Called before any library begins: some that come with MPI take the signal for themselves.
[[gnu::section(".preinit_array"), gnu::used]] void (*const BeforeLibraries)(
  int, char**, char**) = NoteHangup;
#else
const bool HangupWasIgnored = IsIgnored(SIGHUP);
#endif
}

void CatchSignals()
{
  Handle(SIGINT, NoteInterruption);
  Handle(SIGTERM, NoteInterruption);
  Handle(SIGHUP, HangupWasIgnored ? SIG_IGN : NoteInterruption); // as under nohup
  Handle(SIGPIPE, SIG_IGN);
  Handle(SIGCHLD, SIG_DFL); // ignored, it would take the ends of child processes away
  Handle(SIGXFSZ, SIG_IGN);
}

bool IsInterrupted()
{
  return Interrupted != 0;
}
}
