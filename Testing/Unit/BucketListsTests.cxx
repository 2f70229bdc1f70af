// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate/Schedule/BucketLists.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A slow reference implementation of the lists.
class SlowLists
{
public:
  void Add(Index vertex, CostBucket bucket)
  {
    this->Lists[bucket / BucketsPerList].push_back(vertex);
  }

  CostBucket TakeLowest(std::vector<Index>& vertices)
  {
    vertices.clear();
    if (this->Lists.empty())
    {
      return NeverBucket;
    }
    const auto lowest = this->Lists.begin();
    vertices.assign(lowest->second.rbegin(), lowest->second.rend());
    const int bucket = (lowest->first + 1) * BucketsPerList - 1;
    this->Lists.erase(lowest);
    return static_cast<CostBucket>(bucket);
  }

private:
  std::map<int, std::vector<Index>> Lists;
};

/// Takes the lowest list of both and compares. False if there was none.
bool TakesTheSame(BucketLists& lists, SlowLists& slow)
{
  std::vector<Index> found;
  std::vector<Index> expected;
  EXPECT_EQ(lists.TakeLowest(found), slow.TakeLowest(expected));
  EXPECT_EQ(found, expected);
  return !expected.empty();
}
}

TEST(BucketLists, GiveWhatAMapOfListsGivesWhateverIsAddedBetweenTakes)
{
  Random random(5);
  BucketLists lists;
  for (const int count : { 1, 3, 40, BucketLists::NumberOfLists - 1 })
  {
    SlowLists slow;
    lists.Clear();
    for (Index vertex = 0; vertex < 3000; ++vertex)
    {
      const CostBucket bucket = static_cast<CostBucket>(random.Below(count * BucketsPerList));
      lists.Add(vertex, bucket);
      slow.Add(vertex, bucket);
      if (random.Below(20) == 0) // what is added next may lie lower than what was taken
      {
        EXPECT_TRUE(TakesTheSame(lists, slow)) << count;
      }
    }
    while (TakesTheSame(lists, slow))
    {
    }
  }
}

TEST(BucketLists, GiveNothingWhenNothingIsLeftAndAfterClear)
{
  BucketLists lists;
  std::vector<Index> vertices = { 7 };
  EXPECT_EQ(lists.TakeLowest(vertices), NeverBucket);
  EXPECT_TRUE(vertices.empty());
  lists.Add(1, 500);
  lists.Clear();
  EXPECT_EQ(lists.TakeLowest(vertices), NeverBucket);
  EXPECT_TRUE(vertices.empty());
}

TEST(CostBuckets, IncreaseByAFixedNumberForEachDoublingOfTheCost)
{
  EXPECT_EQ(BucketOf(0.0F), 0);
  EXPECT_EQ(BucketOf(std::numeric_limits<float>::infinity()), NeverBucket);
  EXPECT_EQ(BucketOf(std::numeric_limits<float>::quiet_NaN()), NeverBucket);
  EXPECT_LT(BucketOf(std::numeric_limits<float>::max()), NeverBucket);
  Random random(6);
  for (int i = 0; i < 1000; ++i)
  {
    const auto cost = static_cast<float>(random.Between(1e-6, 1e6));
    EXPECT_EQ(BucketOf(2.0F * cost) - BucketOf(cost), BucketsPerDoubling);
    EXPECT_LE(BucketOf(cost), BucketOf(static_cast<float>(cost * random.Between(1.0, 1.1))));
  }
}

TEST(CostBuckets, AreCountedHoweverManyThereAre)
{
  constexpr CostBucket limit = 0x8000;
  Random random(7);
  std::vector<CostBucket> keys(200000);
  std::vector<Index> lower(keys.size() + 1, 0);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    keys[i] = static_cast<CostBucket>(random.Between(0.0, limit + 100.0));
    lower[i + 1] = lower[i] + (keys[i] <= limit ? 1 : 0);
  }
  const std::vector<std::size_t> ends = { 0, 1, 31, 4095, 4096, 4097, 65536, keys.size() };
  for (const std::size_t first : ends)
  {
    for (const std::size_t last : ends)
    {
      if (first <= last)
      {
        EXPECT_EQ(
          CountUpTo(limit, keys.data() + first, keys.data() + last), lower[last] - lower[first]);
      }
    }
  }
}
