// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch/ChildProcess.h"

#include "FilePath.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <windows.h>
// Needs the types of the header above.
#include <psapi.h>

#undef GetMessage // a macro for another function

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxErrors = 1 << 20;   // bytes
constexpr DWORD LeastException = 0xC0000000; // of exit codes: the system ended the process

/// As the C library takes a command line apart again: backslashes are plain but before quotes.
std::string Quoted(const std::string& word)
{
  std::string quoted = "\"";
  std::size_t backslashes = 0;
  for (const char letter : word)
  {
    backslashes = letter == '\\' ? backslashes + 1 : 0;
    quoted += letter == '"' ? std::string(backslashes + 1, '\\') + letter : std::string(1, letter);
  }
  return quoted + std::string(backslashes, '\\') + "\"";
}

std::wstring OwnProgram()
{
  std::array<wchar_t, 32768> path;
  const DWORD length = GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size()));
  return std::wstring(path.data(), length);
}

std::string LastProblem()
{
  return std::system_category().message(static_cast<int>(GetLastError()));
}

/// A file that children may write to, gone when its last handle is closed.
HANDLE MakeTemporaryFile()
{
  std::array<wchar_t, MAX_PATH + 1> folder = {};
  std::array<wchar_t, MAX_PATH + 1> name = {};
  if (GetTempPathW(static_cast<DWORD>(folder.size()), folder.data()) == 0 ||
    GetTempFileNameW(folder.data(), L"bone", 0, name.data()) == 0)
  {
    return INVALID_HANDLE_VALUE;
  }
  return CreateFileW(name.data(), GENERIC_READ | GENERIC_WRITE | DELETE,
    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, CREATE_ALWAYS,
    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
}

HANDLE OpenNowhere(DWORD access)
{
  return CreateFileW(
    L"NUL", access, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr, OPEN_EXISTING, 0, nullptr);
}

/// What a child has as its standard streams; no other child of this process gets them.
class Streams
{
public:
  explicit Streams(HANDLE errors)
    : Handles{ OpenNowhere(GENERIC_READ), OpenNowhere(GENERIC_WRITE), errors }
  {
    for (const HANDLE handle : this->Handles)
    {
      SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    }
  }

  ~Streams()
  {
    CloseHandle(this->Handles[0]);
    CloseHandle(this->Handles[1]);
    SetHandleInformation(this->Handles[2], HANDLE_FLAG_INHERIT, 0);
  }

  Streams(const Streams&) = delete;
  void operator=(const Streams&) = delete;

  STARTUPINFOW StartupInformation() const
  {
    STARTUPINFOW information = {};
    information.cb = sizeof(information);
    information.dwFlags = STARTF_USESTDHANDLES;
    information.hStdInput = this->Handles[0];
    information.hStdOutput = this->Handles[1];
    information.hStdError = this->Handles[2];
    return information;
  }

private:
  std::array<HANDLE, 3> Handles;
};
}

struct ChildProcess::State
{
  HANDLE Errors = MakeTemporaryFile();
  HANDLE Process = nullptr;
  DWORD Number = 0;
  DWORD Status = 0;
  bool Ended = false;

  State() = default;
  State(const State&) = delete;
  void operator=(const State&) = delete;

  ~State()
  {
    CloseHandle(this->Errors);
    CloseHandle(this->Process);
  }
};

ChildProcess::ChildProcess(const std::string& self, const std::vector<std::string>& arguments)
  : Child(std::make_unique<State>())
{
  if (this->Child->Errors == INVALID_HANDLE_VALUE)
  {
    throw Failure(ExitCode::CouldNotWrite, "could not make a temporary file: " + LastProblem());
  }
  std::string words = Quoted(self);
  for (const std::string& argument : arguments)
  {
    words += " " + Quoted(argument);
  }
  std::wstring line = FilePath(words).wstring();
  const Streams streams(this->Child->Errors);
  STARTUPINFOW startup = streams.StartupInformation();
  PROCESS_INFORMATION made = {};
  // A group of its own, so that it can be interrupted alone.
  if (!CreateProcessW(OwnProgram().c_str(), line.data(), nullptr, nullptr, TRUE,
        CREATE_NEW_PROCESS_GROUP, nullptr, nullptr, &startup, &made))
  {
    throw Failure(ExitCode::OutOfMemory, "could not start a process: " + LastProblem());
  }
  CloseHandle(made.hThread);
  this->Child->Process = made.hProcess;
  this->Child->Number = made.dwProcessId;
}

ChildProcess::~ChildProcess()
{
  this->Interrupt();
  WaitForSingleObject(this->Child->Process, INFINITE);
}

bool ChildProcess::HasEnded()
{
  State& child = *this->Child;
  if (!child.Ended && WaitForSingleObject(child.Process, 0) == WAIT_OBJECT_0)
  {
    child.Ended = GetExitCodeProcess(child.Process, &child.Status) != 0;
  }
  return child.Ended;
}

void ChildProcess::Interrupt()
{
  // Without a console there are no such events.
  if (!this->HasEnded() && !GenerateConsoleCtrlEvent(CTRL_BREAK_EVENT, this->Child->Number))
  {
    TerminateProcess(this->Child->Process, static_cast<UINT>(ExitCode::Interrupted));
  }
}

bool ChildProcess::HasDied() const
{
  return this->Child->Status >= LeastException;
}

int ChildProcess::GetProcess() const
{
  return static_cast<int>(this->Child->Number);
}

std::int64_t ChildProcess::GetMemory() const
{
  PROCESS_MEMORY_COUNTERS counters = {};
  return K32GetProcessMemoryInfo(this->Child->Process, &counters, sizeof(counters)) != 0
    ? static_cast<std::int64_t>(counters.WorkingSetSize)
    : 0;
}

ExitCode ChildProcess::GetCode() const
{
  if (this->Child->Status == static_cast<DWORD>(STATUS_CONTROL_C_EXIT))
  {
    return ExitCode::Interrupted; // before it could catch it
  }
  const bool known = this->Child->Status <= static_cast<DWORD>(ExitCode::OutOfMemory);
  return known ? static_cast<ExitCode>(this->Child->Status) : ExitCode::OutOfMemory;
}

std::string ChildProcess::GetErrors() const
{
  std::string text(MaxErrors, '\0');
  DWORD length = 0;
  SetFilePointer(this->Child->Errors, 0, nullptr, FILE_BEGIN);
  ReadFile(this->Child->Errors, text.data(), static_cast<DWORD>(text.size()), &length, nullptr);
  text.resize(length);
  return text;
}

std::string ChildProcess::GetMessage() const
{
  if (this->HasDied())
  {
    return "its process ended with the exception " + std::to_string(this->Child->Status);
  }
  return MessageIn(this->GetErrors());
}
}
