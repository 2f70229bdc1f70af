// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch/ChildProcess.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxErrors = 1 << 20; // bytes
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

struct CloseFile
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
}

struct ChildProcess::State
{
  std::unique_ptr<std::FILE, CloseFile> Errors{ std::tmpfile() }; // nameless and gone with us
  pid_t Process = -1;
  bool Ended = false;
  int Status = 0;
};

ChildProcess::ChildProcess(const std::string& self, const std::vector<std::string>& arguments)
  : Child(std::make_unique<State>())
{
  if (!this->Child->Errors)
  {
    throw Failure(ExitCode::CouldNotWrite,
      std::string("could not make a temporary file: ") + std::strerror(errno));
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(this->Child->Errors.get()), STDERR_FILENO);
  const std::vector<char*> pointers = PointersTo(self, arguments);
  const bool known = access(SelfLink, X_OK) == 0;
  const int problem = posix_spawnp(&this->Child->Process, known ? SelfLink : self.c_str(), &actions,
    nullptr, pointers.data(), environ);
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
  while (!this->Child->Ended)
  {
    const bool again = waitpid(this->Child->Process, &this->Child->Status, 0) < 0 && errno == EINTR;
    this->Child->Ended = !again;
  }
}

bool ChildProcess::HasEnded()
{
  if (!this->Child->Ended)
  {
    this->Child->Ended = waitpid(this->Child->Process, &this->Child->Status, WNOHANG) != 0;
  }
  return this->Child->Ended;
}

void ChildProcess::Interrupt()
{
  if (!this->Child->Ended)
  {
    kill(this->Child->Process, SIGTERM);
  }
}

bool ChildProcess::HasDied() const
{
  return WIFSIGNALED(this->Child->Status);
}

int ChildProcess::GetProcess() const
{
  return this->Child->Process;
}

std::int64_t ChildProcess::GetMemory() const
{
  std::ifstream pages("/proc/" + std::to_string(this->Child->Process) + "/statm");
  std::int64_t all = 0;
  std::int64_t resident = 0;
  return pages >> all >> resident ? resident * sysconf(_SC_PAGESIZE) : 0;
}

ExitCode ChildProcess::GetCode() const
{
  const int signal = this->HasDied() ? WTERMSIG(this->Child->Status) : 0;
  if (signal == SIGTERM || signal == SIGINT || signal == SIGHUP)
  {
    return ExitCode::Interrupted; // before it could catch them
  }
  const bool known = WIFEXITED(this->Child->Status) &&
    WEXITSTATUS(this->Child->Status) <= static_cast<int>(ExitCode::OutOfMemory);
  return known ? static_cast<ExitCode>(WEXITSTATUS(this->Child->Status)) : ExitCode::OutOfMemory;
}

std::string ChildProcess::GetErrors() const
{
  std::string text(MaxErrors, '\0');
  std::FILE* const errors = this->Child->Errors.get();
  const bool isAtStart = std::fseek(errors, 0, SEEK_SET) == 0;
  text.resize(isAtStart ? std::fread(text.data(), 1, text.size(), errors) : 0);
  return text;
}

std::string ChildProcess::GetMessage() const
{
  if (this->HasDied())
  {
    const int signal = WTERMSIG(this->Child->Status);
    return "its process died of signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  return MessageIn(this->GetErrors());
}
}
