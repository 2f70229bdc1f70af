// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#ifdef __linux__
#include <sched.h>
#endif

using namespace bonedecimate;

TEST(Parallel, ARequestedNumberOfThreadsIsTaken)
{
  EXPECT_EQ(ThreadsToUse(3), HasThreads ? 3U : 1U);
  EXPECT_GE(ThreadsToUse(0), 1U);
}

TEST(Parallel, BothAreRunAndWhatOneThrowsIsRethrown)
{
  const auto run = [](int threads, const std::string& thrower)
  {
    std::array<bool, 2> isDone = { false, false };
    const auto task = [&](const std::string& name, bool& done)
    {
      if (name == thrower)
      {
        throw std::runtime_error(name);
      }
      done = true;
    };
    std::string thrown;
    try
    {
      RunBoth(
        threads, [&] { task("other", isDone[0]); }, [&] { task("mine", isDone[1]); });
    }
    catch (const std::runtime_error& error)
    {
      thrown = error.what();
    }
    EXPECT_EQ(thrown, thrower) << threads;
    EXPECT_EQ(isDone[0], thrower != "other") << threads;
    EXPECT_EQ(isDone[1], thrower != "mine") << threads;
  };
  for (const int threads : { 1, 2, 5 })
  {
    run(threads, "");
    run(threads, "other");
    run(threads, "mine");
  }
}

#if defined(__linux__) && !defined(BONEDECIMATE_WITHOUT_THREADS)
TEST(Parallel, OnlyProcessorsOfThisProcessCount)
{
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof(all), &all), 0);
  int first = 0;
  while (!CPU_ISSET(first, &all))
  {
    ++first;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(ThreadsToUse(0), 1U);
  ASSERT_EQ(sched_setaffinity(0, sizeof(all), &all), 0);
  EXPECT_EQ(ThreadsToUse(0), static_cast<unsigned int>(CPU_COUNT(&all)));
}
#endif
