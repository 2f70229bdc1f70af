// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"

#include <gtest/gtest.h>

#ifdef __linux__
#include <sched.h>
#endif

using namespace bonedecimate;

TEST(Parallel, ARequestedNumberOfThreadsIsTaken)
{
  EXPECT_EQ(ThreadsToUse(3), HasThreads ? 3U : 1U);
  EXPECT_GE(ThreadsToUse(0), 1U);
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
