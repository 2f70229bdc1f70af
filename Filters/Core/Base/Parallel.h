// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Parallel.h
 * @brief Distributes independent chunks of work over threads. The chunks do not depend on the
 * number of threads.
 */
#ifndef BoneDecimate_Core_Base_Parallel_h
#define BoneDecimate_Core_Base_Parallel_h

#include "Monitor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace bonedecimate
{
#ifdef BONEDECIMATE_WITHOUT_THREADS
constexpr bool HasThreads = false;
#else
constexpr bool HasThreads = true;
#endif

/// Processors that this process may use: those of a job in a cluster or a container, not all of the
/// machine.
unsigned int NumberOfProcessors();

/// @param requested 0: one thread per processor. 1 is returned where the platform has no threads.
inline unsigned int ThreadsToUse(int requested)
{
  if constexpr (!HasThreads)
  {
    return 1;
  }
  return requested > 0 ? static_cast<unsigned int>(requested) : NumberOfProcessors();
}

/**
 * Starts up to `count` threads that call run(i). If the system lacks threads or memory, fewer
 * start, perhaps none, and the caller has to do their work.
 * @returns Whether all of them were started.
 */
template <typename Run>
bool StartThreads(std::vector<std::thread>& threads, std::size_t count, const Run& run)
{
  try
  {
    threads.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      threads.emplace_back([run, i] { run(i); });
    }
    return true;
  }
  catch (const std::system_error&)
  {
    return false;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}

/// Calls run() and keeps what it throws; an exception must not leave a thread.
template <typename Run>
void KeepFailure(std::exception_ptr& failure, const Run& run)
{
  try
  {
    run();
  }
  catch (...)
  {
    failure = std::current_exception();
  }
}

/// Waits for all threads, then rethrows the first failure.
inline void Join(std::vector<std::thread>& threads, const std::vector<std::exception_ptr>& failures)
{
  for (std::thread& thread : threads)
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
}

/// Calls both, `other` on a thread of its own if there may be several; rethrows what they throw.
template <typename Other, typename Mine>
void RunBoth(int threads, const Other& other, const Mine& mine)
{
  std::vector<std::exception_ptr> failures(2);
  std::vector<std::thread> helper;
  const auto runOther = [&](std::size_t = 0) { KeepFailure(failures[0], other); };
  if (ThreadsToUse(threads) < 2 || !StartThreads(helper, 1, runOther))
  {
    runOther();
  }
  KeepFailure(failures[1], mine);
  Join(helper, failures);
}

/// Number of items in a chunk, small enough for fine steps of progress.
inline std::size_t ChunkSize(std::size_t count)
{
  return std::clamp<std::size_t>(count / 512, 1, 512);
}

inline std::size_t NumberOfChunks(std::size_t count)
{
  return (count + ChunkSize(count) - 1) / ChunkSize(count);
}

/**
 * Calls work(part) once for every part of [0, parts), unless the monitor aborts or a part throws;
 * one of the exceptions is rethrown here. The calling thread also works, and only it calls the
 * monitor.
 * @returns False after an abort.
 */
template <typename Work>
bool ForEachPart(std::size_t parts, int threads, const Monitor& monitor, const Work& work)
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> stopped{ false };
  const auto workUntilDone = [&](auto afterEach)
  {
    for (std::size_t part = next++; part < parts && !stopped; part = next++)
    {
      work(part);
      afterEach();
    }
  };
  const unsigned int helpers =
    static_cast<unsigned int>(std::min<std::size_t>(ThreadsToUse(threads), parts)) - (parts > 0);
  std::vector<std::exception_ptr> failures(helpers + 1);
  const auto guarded = [&](std::exception_ptr& failure, auto afterEach)
  {
    KeepFailure(failure, [&] { workUntilDone(afterEach); });
    if (failure)
    {
      stopped = true;
    }
  };
  std::vector<std::thread> pool;
  StartThreads(pool, helpers, [&](std::size_t i) { guarded(failures[i], [] {}); });
  double reported = 0.0;
  guarded(failures[helpers],
    [&]
    {
      reported = static_cast<double>(std::min(next.load(), parts)) / static_cast<double>(parts);
      stopped = stopped || (monitor && !monitor(reported));
    });
  Join(pool, failures);
  const bool isUnreported = parts > 0 && reported < 1.0; // another thread did the last part
  return !stopped && !(isUnreported && monitor && !monitor(1.0));
}

/// Calls work(chunk, first, last) for every chunk of [0, count), as ForEachPart does.
template <typename Work>
bool ForEachChunk(std::size_t count, int threads, const Monitor& monitor, const Work& work)
{
  const std::size_t size = ChunkSize(count);
  return ForEachPart(NumberOfChunks(count), threads, monitor,
    [&](std::size_t chunk) { work(chunk, chunk * size, std::min(count, (chunk + 1) * size)); });
}

/// Number of items in a block: enough short, uniform work to be worth a thread.
constexpr std::size_t BlockSize = 8192;

inline std::size_t NumberOfBlocks(std::size_t count)
{
  return (count + BlockSize - 1) / BlockSize;
}

/// Calls work(block, first, last) once for every block of [0, count); cannot be aborted.
template <typename Work>
void ForEachBlock(std::size_t count, int threads, const Work& work)
{
  ForEachPart(NumberOfBlocks(count), threads, Monitor(),
    [&](std::size_t block)
    { work(block, block * BlockSize, std::min(count, (block + 1) * BlockSize)); });
}

/// The sum of part(first, last) over the blocks of [0, count), added in the order of the blocks.
template <typename Part>
auto SumOverBlocks(std::size_t count, int threads, const Part& part)
{
  std::vector<decltype(part(count, count))> parts(NumberOfBlocks(count));
  ForEachBlock(count, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    { parts[block] = part(first, last); });
  decltype(part(count, count)) sum{};
  for (const auto& each : parts)
  {
    sum += each;
  }
  return sum;
}

/// Calls work(id) for every id of [0, count), in blocks.
template <typename Work>
void ForEachId(std::size_t count, int threads, const Work& work)
{
  ForEachBlock(count, threads,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t id = first; id < last; ++id)
      {
        work(id);
      }
    });
}

/// For each block, the number of selected ids before it; finally, the number of all. These are the
/// offsets of the blocks in the list of selected ids.
template <typename IsChosen>
std::vector<std::size_t> StartsOfBlocks(std::size_t count, int threads, const IsChosen& isChosen)
{
  std::vector<std::size_t> starts(NumberOfBlocks(count) + 1, 0);
  ForEachBlock(count, threads,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t id = first; id < last; ++id)
      {
        starts[block + 1] += isChosen(id) ? 1 : 0;
      }
    });
  for (std::size_t block = 1; block < starts.size(); ++block)
  {
    starts[block] += starts[block - 1];
  }
  return starts;
}
}

#endif
