// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildProcess.h
 * @brief This program again, for one bone of many: what goes wrong there stays there.
 */
#ifndef BoneDecimate_Applications_ChildProcess_h
#define BoneDecimate_Applications_ChildProcess_h

#include "ExitCode.h"

#include <cstdio>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace bonedecimate
{
class ChildProcess
{
public:
  /// @param self argv[0], for systems that do not know /proc/self/exe.
  /// @throws Failure(ExitCode::OutOfMemory) if the system gives no further process.
  ChildProcess(const std::string& self, const std::vector<std::string>& arguments);

  /// Interrupts it if it is still at work, and waits for its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  void operator=(const ChildProcess&) = delete;

  /// Whether it has ended; does not wait.
  bool HasEnded();

  /// Sends it the signal of an interruption.
  void Interrupt();

  /// Whether it ended by a signal, with no chance to put anything in order.
  bool HasDied() const;

  int GetProcess() const { return this->Process; }

  /// Of an ended child. One that died counts as out of memory, the usual cause of it.
  ExitCode GetCode() const;

  /// What it said on its standard error, or by which signal it died.
  std::string GetMessage() const;

private:
  struct CloseFile
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, CloseFile> Errors; // nameless and gone with us
  pid_t Process = -1;
  bool Ended = false;
  int Status = 0;
};
}

#endif
