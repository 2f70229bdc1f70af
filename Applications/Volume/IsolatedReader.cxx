// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolatedReader.h"

#include "LabelFields.h"
#include "Pipe.h"

#include <cerrno>
#include <exception>
#include <fcntl.h>
#include <new>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bonedecimate::volume
{
namespace
{
enum ChildStatus
{
  Done = 0,
  Failed = 1,
  OutOfMemory = 2
};

struct Shape
{
  std::array<std::int64_t, 3> Size;
  int ScalarType;
};

std::size_t BytesOf(vtkImageData* image)
{
  return static_cast<std::size_t>(image->GetNumberOfPoints()) *
    static_cast<std::size_t>(image->GetScalarSize());
}

void Send(const Volume& volume, Pipe& pipe)
{
  pipe.SendText(volume.Problem);
  pipe.SendText(volume.Note);
  if (volume.Problem.empty())
  {
    const int* size = volume.Image->GetDimensions();
    const Shape shape{ { { size[0], size[1], size[2] } }, volume.Image->GetScalarType() };
    pipe.Send(&volume.Geometry, sizeof(volume.Geometry));
    pipe.Send(&shape, sizeof(shape));
    pipe.Send(volume.Image->GetScalarPointer(), BytesOf(volume.Image));
    SendLabelFields(volume.Image->GetFieldData(), pipe);
  }
}

/// False if the child ended before it had sent all.
bool Receive(Pipe& pipe, Volume& volume)
{
  if (!pipe.ReceiveText(volume.Problem) || !pipe.ReceiveText(volume.Note))
  {
    return false;
  }
  if (!volume.Problem.empty())
  {
    return true;
  }
  Shape shape;
  if (!pipe.Receive(&volume.Geometry, sizeof(volume.Geometry)) ||
    !pipe.Receive(&shape, sizeof(shape)))
  {
    return false;
  }
  volume.Image = AllocateImage(shape.Size, shape.ScalarType);
  return pipe.Receive(volume.Image->GetScalarPointer(), BytesOf(volume.Image)) &&
    ReceiveLabelFields(pipe, volume.Image->GetFieldData());
}

/// The life of the child.
[[noreturn]] void RunChild(const std::function<Volume()>& read, Pipe& pipe)
{
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  ChildStatus status = Done;
  try
  {
    Send(read(), pipe);
  }
  catch (const std::bad_alloc&)
  {
    status = OutOfMemory;
  }
  catch (const std::exception&)
  {
    status = Failed;
  }
  _exit(status); // without the ends that the parent's objects are due
}

int WaitFor(pid_t child)
{
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : Failed;
}
}

Volume ReadIsolated(const std::function<Volume()>& read)
{
  Pipe pipe;
  const pid_t child = pipe.IsOpen() ? fork() : -1;
  if (child < 0)
  {
    return RejectedVolume("the system gives no process to read it in");
  }
  if (child == 0)
  {
    pipe.CloseReceiver();
    RunChild(read, pipe);
  }
  pipe.CloseSender();
  Volume volume;
  const bool isComplete = Receive(pipe, volume);
  pipe.CloseReceiver();
  if (WaitFor(child) == OutOfMemory)
  {
    throw std::bad_alloc();
  }
  return isComplete ? volume : RejectedVolume("it is damaged");
}
}
