// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WorkerTeam.h
 * @brief Threads that wait between short tasks, whereas ForEachPart of Parallel.h starts new
 * threads for each task.
 */
#ifndef BoneDecimate_Core_Base_WorkerTeam_h
#define BoneDecimate_Core_Base_WorkerTeam_h

#include "Parallel.h"

#include <condition_variable>
#include <functional>
#include <mutex>

namespace bonedecimate
{
class WorkerTeam
{
public:
  using Work = std::function<void(std::size_t part)>;

  /// @param threads As for ThreadsToUse(); the calling thread is one of them.
  explicit WorkerTeam(int threads)
    : Failures(ThreadsToUse(threads))
  {
    StartThreads(
      this->Threads, this->Failures.size() - 1, [this](std::size_t i) { this->Serve(i + 1); });
  }
  ~WorkerTeam()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsOver = true;
    }
    this->Begins.notify_all();
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }
  WorkerTeam(const WorkerTeam&) = delete;
  WorkerTeam& operator=(const WorkerTeam&) = delete;

  /// Calls work(part) once for each part of [0, parts); returns when all are done. If a part
  /// throws, the others may not be called, and an exception is rethrown here.
  void Run(std::size_t parts, const Work& work)
  {
    this->Begin(parts, work);
    this->Take(0);
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Ends.wait(lock, [this] { return this->Busy == 0; });
    std::exception_ptr first;
    for (std::exception_ptr& failure : this->Failures)
    {
      first = first ? first : failure;
      failure = nullptr;
    }
    if (first)
    {
      std::rethrow_exception(first);
    }
  }

private:
  void Begin(std::size_t parts, const Work& work)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Current = &work;
      this->Parts = parts;
      this->Next = 0;
      this->Busy = this->Threads.size();
      ++this->Round;
    }
    this->Begins.notify_all();
  }

  void Serve(std::size_t worker)
  {
    std::size_t seen = 0;
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      this->Begins.wait(lock, [&] { return this->IsOver || this->Round != seen; });
      if (this->IsOver)
      {
        return;
      }
      seen = this->Round;
      lock.unlock();
      this->Take(worker);
      lock.lock();
      if (--this->Busy == 0)
      {
        this->Ends.notify_one();
      }
    }
  }

  void Take(std::size_t worker)
  {
    try
    {
      for (std::size_t part = this->Next++; part < this->Parts; part = this->Next++)
      {
        (*this->Current)(part);
      }
    }
    catch (...)
    {
      this->Failures[worker] = std::current_exception();
      this->Next = this->Parts;
    }
  }

  std::mutex Mutex;
  std::condition_variable Begins, Ends;
  const Work* Current = nullptr;
  std::size_t Parts = 0;
  std::atomic<std::size_t> Next{ 0 };
  std::size_t Busy = 0;  // threads besides the calling one
  std::size_t Round = 0; // calls of Run
  bool IsOver = false;
  std::vector<std::exception_ptr> Failures; // of each worker
  std::vector<std::thread> Threads;
};
}

#endif
