// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolatedReader.h"

#include "CurrentFile.h"
#include "Pipe.h"
#include "SentFields.h"

#include <cerrno>
#include <csignal>
#include <exception>
#include <fcntl.h>
#include <new>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

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

/// The part of a header that has a fixed size.
struct Shape
{
  std::array<std::int64_t, 3> Size;
  int ScalarType;
  bool IsReadWhole;
};

bool SendHeader(const VolumeHeader& header, Pipe& pipe)
{
  if (!pipe.SendText(header.Problem) || !pipe.SendText(header.Note) ||
    !pipe.SendText(header.Remark) || !header.Problem.empty())
  {
    return false;
  }
  const Shape shape{ header.Size, header.ScalarType, header.IsReadWhole };
  SendLabelFields(header.Fields, pipe);
  const std::size_t layers = header.Layers.size();
  return pipe.Send(&header.Geometry, sizeof(header.Geometry)) && pipe.Send(&shape, sizeof(shape)) &&
    pipe.Send(&layers, sizeof(layers)) && pipe.Send(header.Layers.data(), layers * sizeof(double));
}

/// Each layer comes behind a text that is empty if there is a layer.
void SendVolume(const LayeredVolume& volume, Pipe& pipe)
{
  bool shouldContinue = SendHeader(volume.Header, pipe);
  std::vector<char> layer(shouldContinue ? volume.Header.BytesInALayer() : 0);
  for (std::int64_t k = 0; shouldContinue && k < volume.Header.Size[2]; ++k)
  {
    const std::string problem = volume.ReadLayer(layer.data());
    shouldContinue =
      pipe.SendText(problem) && problem.empty() && pipe.Send(layer.data(), layer.size());
  }
}

/// The child ends by signals that its parent only notes, and with its parent.
void TakeSignals()
{
  for (const int number : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction action = {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
    {
      std::signal(number, SIG_DFL);
    }
  }
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

/// The life of the child.
[[noreturn]] void RunChild(const std::function<LayeredVolume()>& open, Pipe& pipe)
{
  TakeSignals();
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  ChildStatus status = Done;
  try
  {
    SendVolume(open(), pipe);
  }
  catch (const std::bad_alloc&)
  {
    status = OutOfMemory;
  }
  catch (const std::exception&)
  {
    status = Failed;
  }
  _exit(status); // destructors are for the parent alone
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

/// The child.
struct IsolatedReader::Source
{
  Pipe FromChild;
  pid_t Child = -1;

  Source() = default;
  Source(const Source&) = delete;
  void operator=(const Source&) = delete;
  ~Source();

  bool ReceiveHeader(VolumeHeader& header);
  int End();
  std::string ReasonOfEnd();
};

/// A library may wait for what never comes, so the child is not waited for.
IsolatedReader::Source::~Source()
{
  if (this->Child > 0)
  {
    kill(this->Child, SIGKILL);
  }
  this->End();
}

void StopReadingBy(void (*stopIfInterrupted)())
{
  SetCheckWhileWaiting(stopIfInterrupted);
}

IsolatedReader::IsolatedReader(const std::string& problem)
{
  this->Header.Problem = problem;
}

IsolatedReader::IsolatedReader(const std::function<LayeredVolume()>& open)
  : From(std::make_unique<Source>())
{
  Source& from = *this->From;
  ResetCurrentFile();
  from.Child = from.FromChild.IsOpen() ? fork() : -1;
  if (from.Child < 0)
  {
    this->Header.Problem = "the system gives no process to read it in";
    return;
  }
  if (from.Child == 0)
  {
    from.FromChild.CloseReceiver();
    RunChild(open, from.FromChild);
  }
  from.FromChild.CloseSender();
  if (!from.ReceiveHeader(this->Header))
  {
    this->Header.Problem = from.ReasonOfEnd();
  }
}

IsolatedReader::~IsolatedReader() = default;

/// False if the child ended before it had sent all.
bool IsolatedReader::Source::ReceiveHeader(VolumeHeader& header)
{
  if (!this->FromChild.ReceiveText(header.Problem) || !this->FromChild.ReceiveText(header.Note) ||
    !this->FromChild.ReceiveText(header.Remark))
  {
    return false;
  }
  Shape shape{};
  if (!header.Problem.empty())
  {
    return true;
  }
  std::size_t layers = 0;
  const bool isComplete = ReceiveLabelFields(this->FromChild, header.Fields) &&
    this->FromChild.Receive(&header.Geometry, sizeof(header.Geometry)) &&
    this->FromChild.Receive(&shape, sizeof(shape)) &&
    this->FromChild.Receive(&layers, sizeof(layers));
  header.Size = shape.Size;
  header.ScalarType = shape.ScalarType;
  header.IsReadWhole = shape.IsReadWhole;
  header.Layers.resize(isComplete ? layers : 0);
  return isComplete && this->FromChild.Receive(header.Layers.data(), layers * sizeof(double));
}

std::string IsolatedReader::ReadLayers(std::int64_t count, void* values)
{
  const std::size_t bytes = this->Header.BytesInALayer();
  for (std::int64_t k = 0; k < count; ++k)
  {
    std::string problem;
    char* const layer = static_cast<char*>(values) + static_cast<std::size_t>(k) * bytes;
    if (!this->From->FromChild.ReceiveText(problem))
    {
      return this->From->ReasonOfEnd();
    }
    if (!problem.empty())
    {
      return problem;
    }
    if (!this->From->FromChild.Receive(layer, bytes))
    {
      return this->From->ReasonOfEnd();
    }
  }
  return std::string();
}

int IsolatedReader::Source::End()
{
  this->FromChild.CloseReceiver();
  return this->Child > 0 ? WaitFor(std::exchange(this->Child, -1)) : Done;
}

std::string IsolatedReader::Source::ReasonOfEnd()
{
  CheckWhileWaiting(); // the signal may have ended the child, too
  if (this->End() == OutOfMemory)
  {
    throw std::bad_alloc();
  }
  const std::string file = CurrentFile();
  return file.empty() ? "it is damaged" : DamagedFileProblem(file);
}
}
