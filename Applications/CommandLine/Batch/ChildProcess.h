// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildProcess.h
 * @brief This program again, for one bone of many: what goes wrong there stays there.
 */
#ifndef BoneDecimate_Applications_ChildProcess_h
#define BoneDecimate_Applications_ChildProcess_h

#include "ExitCode.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bonedecimate
{
class ChildProcess
{
public:
  /// @param self argv[0], where the system does not tell which program runs.
  /// @throws Failure(ExitCode::OutOfMemory) if the system gives no further process.
  ChildProcess(const std::string& self, const std::vector<std::string>& arguments);

  /// Interrupts it if it is still at work, and waits for its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  void operator=(const ChildProcess&) = delete;

  /// Whether it has ended; does not wait.
  bool HasEnded();

  /// As Interruption.h has it: it is to put things in order and end.
  void Interrupt();

  /// Whether the system ended it, with no chance to put anything in order.
  bool HasDied() const;

  int GetProcess() const;

  /// Bytes of physical memory that it has now; 0 if it has ended, or the system does not tell.
  std::int64_t GetMemory() const;

  /// Exit code of an ended child. One that died counts as out of memory, the usual cause.
  ExitCode GetCode() const;

  /// What it wrote on its standard error.
  std::string GetErrors() const;
  /// The first line of that, or what it died of.
  std::string GetMessage() const;

private:
  struct State;
  std::unique_ptr<State> Child;
};

/// The first line of what the program wrote, without its name.
std::string MessageIn(const std::string& errors);
}

#endif
