// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate/Schedule/VertexQueue.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The interface of VertexQueue, implemented by a sorted set.
class SlowQueue
{
public:
  explicit SlowQueue(Index count)
    : Costs(count, 0.0)
    , Present(count, false)
  {
  }
  bool IsEmpty() const { return this->Sorted.empty(); }
  void Remove(Index vertex)
  {
    if (this->Present[vertex])
    {
      this->Sorted.erase({ this->Costs[vertex], vertex });
      this->Present[vertex] = false;
    }
  }
  void Set(Index vertex, double cost)
  {
    this->Remove(vertex);
    this->Sorted.insert({ cost, vertex });
    this->Costs[vertex] = cost;
    this->Present[vertex] = true;
  }
  Index PopLowest()
  {
    const Index vertex = this->Sorted.begin()->second;
    this->Remove(vertex);
    return vertex;
  }

private:
  std::set<std::pair<double, Index>> Sorted;
  std::vector<double> Costs;
  std::vector<bool> Present;
};

void Compare(std::uint64_t seed, Index count, int differentCosts)
{
  Random random(seed);
  VertexQueue queue(count);
  SlowQueue slow(count);
  for (int step = 0; step < 20000; ++step)
  {
    const double what = random.Uniform();
    const Index vertex = random.Below(count);
    if (what < 0.6)
    {
      const double cost = random.Below(differentCosts);
      queue.Set(vertex, cost);
      slow.Set(vertex, cost);
    }
    else if (what < 0.75)
    {
      queue.Remove(vertex);
      slow.Remove(vertex);
    }
    else if (!slow.IsEmpty())
    {
      ASSERT_FALSE(queue.IsEmpty());
      ASSERT_EQ(queue.PopLowest(), slow.PopLowest()) << "step " << step;
    }
    ASSERT_EQ(queue.IsEmpty(), slow.IsEmpty()) << "step " << step;
  }
  while (!slow.IsEmpty())
  {
    ASSERT_EQ(queue.PopLowest(), slow.PopLowest());
  }
  EXPECT_TRUE(queue.IsEmpty());
}
}

TEST(VertexQueue, OrderVsSortedSet)
{
  Compare(1, 200, 1000000);
  Compare(2, 3000, 1000000);
}

TEST(VertexQueue, OrderVsSortedSetWithManyEqualCosts)
{
  Compare(3, 200, 3);
  Compare(4, 5, 2);
  Compare(5, 1, 1);
}

TEST(VertexQueue, EqualCostsComeByVertex)
{
  VertexQueue queue(100);
  for (Index v = 99; v >= 0; --v)
  {
    queue.Set(v, 1.0);
  }
  for (Index v = 0; v < 100; ++v)
  {
    EXPECT_EQ(queue.PopLowest(), v);
  }
}

TEST(VertexQueue, InfiniteCostsComeLastAndNegativeOnesFirst)
{
  VertexQueue queue(3);
  queue.Set(0, std::numeric_limits<double>::infinity());
  queue.Set(1, 0.0);
  queue.Set(2, -1e-20);
  EXPECT_EQ(queue.PopLowest(), 2);
  EXPECT_EQ(queue.PopLowest(), 1);
  EXPECT_EQ(queue.PopLowest(), 0);
}

TEST(VertexQueue, RemovingWhatIsNotThereChangesNothing)
{
  VertexQueue queue(4);
  queue.Remove(2);
  EXPECT_TRUE(queue.IsEmpty());
  queue.Set(1, 5.0);
  queue.Remove(2);
  EXPECT_EQ(queue.PopLowest(), 1);
  queue.Remove(1);
  EXPECT_TRUE(queue.IsEmpty());
}
