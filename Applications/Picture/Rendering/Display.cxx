// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#ifdef BONEDECIMATE_RENDERS_THROUGH_X

#include <X11/Xlib.h>

#include <cstdlib>
#include <optional>

#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bonedecimate
{
namespace
{
constexpr int StartTimeout = 30000; // ms, generous: the machine may be busy
constexpr const char* Missing =
  "there is no usable X display, and no Xvfb to make one (Debian package xvfb)";

/// A connection to the display of the environment, or null if it is dead or cannot do OpenGL.
::Display* Connect()
{
  ::Display* connection = XOpenDisplay(nullptr);
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (connection && !XQueryExtension(connection, "GLX", &opcode, &event, &error))
  {
    XCloseDisplay(connection);
    connection = nullptr;
  }
  return connection;
}

std::optional<std::string> GetEnvironment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

void SetEnvironment(const char* name, const std::optional<std::string>& value)
{
  if (value)
  {
    setenv(name, value->c_str(), 1);
  }
  else
  {
    unsetenv(name);
  }
}

/// The server writes its display's number and a line end once it is ready; anything else is empty.
std::string ReadDisplayNumber(int descriptor)
{
  std::string number;
  pollfd waiting = { descriptor, POLLIN, 0 };
  char letter = 0;
  while (poll(&waiting, 1, StartTimeout) > 0 && read(descriptor, &letter, 1) == 1)
  {
    if (letter == '\n')
    {
      return number;
    }
    number += letter;
  }
  return {};
}
}

/// The display in use. Its connection stays open: many servers start afresh when their last client
/// goes, and VTK would meet them in the middle of that.
struct Display::Server
{
  ::pid_t Process = 0; // of a server of our own, else 0
  ::Display* Connection = nullptr;
  std::optional<std::string> OldDisplay;

  ~Server();
  bool Start();
  bool Spawn(int descriptor);
};

Display::Server::~Server()
{
  if (this->Connection)
  {
    XCloseDisplay(this->Connection);
    SetEnvironment("DISPLAY", this->OldDisplay);
  }
  if (this->Process > 0)
  {
    kill(this->Process, SIGTERM);
    waitpid(this->Process, nullptr, 0);
  }
}

bool Display::Server::Spawn(int descriptor)
{
  const std::string number = std::to_string(descriptor);
  // With -terminate the server goes when its last client goes. Our own connection is that client,
  // so that no server is left behind even where VTK ends the program.
  const char* arguments[] = { "Xvfb", "-displayfd", number.c_str(), "-terminate", "-nolisten",
    "tcp", "-screen", "0", "1280x1024x24", nullptr };
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // A group of its own: an interrupt typed at the terminal is for the program, not for the server
  // under it. A server that finds SIGUSR1 ignored would signal its parent.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGUSR1);
  sigaddset(&defaults, SIGTERM);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  const int failure = posix_spawnp(
    &this->Process, "Xvfb", &files, &attributes, const_cast<char* const*>(arguments), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  this->Process = failure ? 0 : this->Process;
  return failure == 0;
}

bool Display::Server::Start()
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return false;
  }
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const bool isSpawned = this->Spawn(ends[1]);
  close(ends[1]);
  const std::string number = isSpawned ? ReadDisplayNumber(ends[0]) : std::string();
  close(ends[0]);
  if (number.empty())
  {
    return false;
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  this->Connection = Connect();
  if (!this->Connection)
  {
    SetEnvironment("DISPLAY", this->OldDisplay);
  }
  return this->Connection != nullptr;
}

Display::Display(Choice choice)
{
  this->Used = std::make_unique<Server>();
  this->Used->Connection = choice == Choice::Any ? Connect() : nullptr;
  this->Used->OldDisplay = GetEnvironment("DISPLAY");
  if (!this->Used->Connection && !this->Used->Start())
  {
    this->Used.reset();
    this->Problem = Missing;
  }
}

Display::~Display() = default;
}

#else

namespace bonedecimate
{
struct Display::Server
{
};

Display::Display(Choice) {}

Display::~Display() = default;
}

#endif
