// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bonedecimate
{
namespace
{
const char* const SelfLink = "/proc/self/exe";

std::vector<char*> PointersTo(const std::string& self, const std::vector<std::string>& arguments)
{
  std::vector<char*> pointers = { const_cast<char*>(self.c_str()) };
  for (const std::string& argument : arguments)
  {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  return pointers;
}
}

ChildProcess::ChildProcess(const std::string& self, const std::vector<std::string>& arguments)
  : Errors(std::tmpfile())
{
  if (!this->Errors)
  {
    throw Failure(ExitCode::CouldNotWrite,
      std::string("could not make a temporary file: ") + std::strerror(errno));
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(this->Errors.get()), STDERR_FILENO);
  const std::vector<char*> pointers = PointersTo(self, arguments);
  const bool known = access(SelfLink, X_OK) == 0;
  const int problem = posix_spawnp(
    &this->Process, known ? SelfLink : self.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0)
  {
    throw Failure(
      ExitCode::OutOfMemory, std::string("could not start a process: ") + std::strerror(problem));
  }
}

ChildProcess::~ChildProcess()
{
  this->Interrupt();
  while (!this->Ended)
  {
    const bool again = waitpid(this->Process, &this->Status, 0) < 0 && errno == EINTR;
    this->Ended = !again;
  }
}

bool ChildProcess::HasEnded()
{
  if (!this->Ended)
  {
    this->Ended = waitpid(this->Process, &this->Status, WNOHANG) == this->Process;
  }
  return this->Ended;
}

void ChildProcess::Interrupt()
{
  if (!this->Ended)
  {
    kill(this->Process, SIGTERM);
  }
}

bool ChildProcess::HasDied() const
{
  return WIFSIGNALED(this->Status);
}

ExitCode ChildProcess::GetCode() const
{
  const int signal = this->HasDied() ? WTERMSIG(this->Status) : 0;
  if (signal == SIGTERM || signal == SIGINT || signal == SIGHUP)
  {
    return ExitCode::Interrupted; // before it could catch them
  }
  const bool known =
    WIFEXITED(this->Status) && WEXITSTATUS(this->Status) <= static_cast<int>(ExitCode::OutOfMemory);
  return known ? static_cast<ExitCode>(WEXITSTATUS(this->Status)) : ExitCode::OutOfMemory;
}

std::string ChildProcess::GetMessage() const
{
  if (this->HasDied())
  {
    const int signal = WTERMSIG(this->Status);
    return "its process died of signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  std::string text(4096, '\0');
  const bool isAtStart = std::fseek(this->Errors.get(), 0, SEEK_SET) == 0;
  text.resize(isAtStart ? std::fread(text.data(), 1, text.size(), this->Errors.get()) : 0);
  text.resize(std::min(text.find('\n'), text.size()));
  const std::string program = "bonedecimate: ";
  return text.compare(0, program.size(), program) == 0 ? text.substr(program.size()) : text;
}
}
