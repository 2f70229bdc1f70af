// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Parallel.h
 * @brief Independent chunks of work over threads, with the same chunks whatever the number of threads.
 */
#ifndef BoneDecimate_Core_Parallel_h
#define BoneDecimate_Core_Parallel_h

#include "Monitor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace bonedecimate
{
/// 0 means one per processor.
inline unsigned int ThreadsToUse(int asked)
{
  return asked > 0 ? static_cast<unsigned int>(asked)
                   : std::max(1U, std::thread::hardware_concurrency());
}

/// Small enough for progress in fine steps, whatever the amount of work.
inline std::size_t ChunkSize(std::size_t count)
{
  return std::clamp<std::size_t>(count / 512, 1, 512);
}

inline std::size_t NumberOfChunks(std::size_t count)
{
  return (count + ChunkSize(count) - 1) / ChunkSize(count);
}

/**
 * Calls work(chunk, first, last) for every chunk of [0, count), each exactly once, unless the monitor says stop or
 * a chunk throws (the first exception by arrival is rethrown here). The calling thread works along and alone calls
 * the monitor. Returns false if it was stopped.
 */
template <typename Work>
bool ForEachChunk(std::size_t count, int threads, const Monitor& monitor, const Work& work)
{
  const std::size_t size = ChunkSize(count);
  const std::size_t chunks = NumberOfChunks(count);
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> stopped{ false };
  const auto workUntilDone = [&](auto afterEach)
  {
    for (std::size_t chunk = next++; chunk < chunks && !stopped; chunk = next++)
    {
      work(chunk, chunk * size, std::min(count, (chunk + 1) * size));
      afterEach();
    }
  };
  const unsigned int helpers =
    static_cast<unsigned int>(std::min<std::size_t>(ThreadsToUse(threads), chunks)) - (chunks > 0);
  std::vector<std::exception_ptr> failures(helpers + 1);
  const auto guarded = [&](std::exception_ptr& failure, auto afterEach)
  {
    try
    {
      workUntilDone(afterEach);
    }
    catch (...)
    {
      failure = std::current_exception();
      stopped = true;
    }
  };
  std::vector<std::thread> pool;
  for (unsigned int i = 0; i < helpers; ++i)
  {
    pool.emplace_back([&, i] { guarded(failures[i], [] {}); });
  }
  guarded(failures[helpers],
    [&]
    {
      const double done =
        static_cast<double>(std::min(next.load(), chunks)) / static_cast<double>(chunks);
      stopped = stopped || !monitor(done);
    });
  for (std::thread& thread : pool)
  {
    thread.join();
  }
  for (const std::exception_ptr& failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
  return !stopped;
}
}

#endif
