// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipe.h"

#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace bonedecimate::volume
{
namespace
{
void (*Check)() = nullptr;

/// A signal between a look at its flag and a read would be missed: so the wait is never long.
void WaitForBytes(int file)
{
  constexpr int milliseconds = 100;
  pollfd waiting{ file, POLLIN, 0 };
  do
  {
    CheckWhileWaiting();
  } while (poll(&waiting, 1, milliseconds) <= 0);
}
}

void SetCheckWhileWaiting(void (*check)())
{
  Check = check;
}

void CheckWhileWaiting()
{
  if (Check)
  {
    Check();
  }
}

Pipe::Pipe()
{
  if (pipe(this->Ends.data()) != 0)
  {
    this->Ends = { { -1, -1 } };
  }
}

Pipe::~Pipe()
{
  this->CloseReceiver();
  this->CloseSender();
}

bool Pipe::IsOpen() const
{
  return this->Ends[0] >= 0;
}

void Pipe::CloseReceiver()
{
  this->Close(0);
}

void Pipe::CloseSender()
{
  this->Close(1);
}

void Pipe::Close(std::size_t end)
{
  if (this->Ends[end] >= 0)
  {
    close(this->Ends[end]);
    this->Ends[end] = -1;
  }
}

bool Pipe::Send(const void* bytes, std::size_t count)
{
  const char* rest = static_cast<const char*>(bytes);
  while (count > 0)
  {
    const ssize_t done = write(this->Ends[1], rest, count);
    if (done > 0)
    {
      rest += done;
      count -= static_cast<std::size_t>(done);
    }
    else if (errno != EINTR)
    {
      return false;
    }
  }
  return true;
}

bool Pipe::Receive(void* bytes, std::size_t count)
{
  char* rest = static_cast<char*>(bytes);
  while (count > 0)
  {
    WaitForBytes(this->Ends[0]);
    const ssize_t done = read(this->Ends[0], rest, count);
    if (done > 0)
    {
      rest += done;
      count -= static_cast<std::size_t>(done);
    }
    else if (done == 0 || errno != EINTR)
    {
      return false;
    }
  }
  return true;
}

bool Pipe::SendText(const std::string& text)
{
  const std::size_t size = text.size();
  return this->Send(&size, sizeof(size)) && this->Send(text.data(), size);
}

bool Pipe::ReceiveText(std::string& text)
{
  std::size_t size = 0;
  if (!this->Receive(&size, sizeof(size)))
  {
    return false;
  }
  text.resize(size);
  return this->Receive(text.data(), size);
}
}
