// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/LevelLists.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// What the lists should be, the slow way.
class SlowLists
{
public:
  void Add(Index vertex, CostKey key) { this->Levels[key / KeysOfLevel].push_back(vertex); }

  CostKey TakeLowest(std::vector<Index>& vertices)
  {
    vertices.clear();
    if (this->Levels.empty())
    {
      return NeverKey;
    }
    const auto lowest = this->Levels.begin();
    vertices.assign(lowest->second.rbegin(), lowest->second.rend());
    const int key = (lowest->first + 1) * KeysOfLevel - 1;
    this->Levels.erase(lowest);
    return static_cast<CostKey>(key);
  }

private:
  std::map<int, std::vector<Index>> Levels;
};

/// Takes the lowest list of both and compares. False if there was none.
bool TakesTheSame(LevelLists& lists, SlowLists& slow)
{
  std::vector<Index> found;
  std::vector<Index> expected;
  EXPECT_EQ(lists.TakeLowest(found), slow.TakeLowest(expected));
  EXPECT_EQ(found, expected);
  return !expected.empty();
}
}

TEST(LevelLists, GiveWhatAMapOfListsGivesWhateverIsAddedBetweenTakes)
{
  Random random(5);
  LevelLists lists;
  for (const int levels : { 1, 3, 40, LevelLists::NumberOfLevels - 1 })
  {
    SlowLists slow;
    lists.Clear();
    for (Index vertex = 0; vertex < 3000; ++vertex)
    {
      const CostKey key = static_cast<CostKey>(random.Below(levels * KeysOfLevel));
      lists.Add(vertex, key);
      slow.Add(vertex, key);
      if (random.Below(20) == 0) // what is added next may lie lower than what was taken
      {
        EXPECT_TRUE(TakesTheSame(lists, slow)) << levels;
      }
    }
    while (TakesTheSame(lists, slow))
    {
    }
  }
}

TEST(LevelLists, GiveNothingWhenNothingIsLeftAndAfterClear)
{
  LevelLists lists;
  std::vector<Index> vertices = { 7 };
  EXPECT_EQ(lists.TakeLowest(vertices), NeverKey);
  EXPECT_TRUE(vertices.empty());
  lists.Add(1, 500);
  lists.Clear();
  EXPECT_EQ(lists.TakeLowest(vertices), NeverKey);
  EXPECT_TRUE(vertices.empty());
}

TEST(CostKeys, RiseWithTheCostByAnOctaveForEachDoubling)
{
  EXPECT_EQ(KeyOf(0.0F), 0);
  EXPECT_EQ(KeyOf(std::numeric_limits<float>::infinity()), NeverKey);
  EXPECT_EQ(KeyOf(std::numeric_limits<float>::quiet_NaN()), NeverKey);
  EXPECT_LT(KeyOf(std::numeric_limits<float>::max()), NeverKey);
  Random random(6);
  for (int i = 0; i < 1000; ++i)
  {
    const auto cost = static_cast<float>(random.Between(1e-6, 1e6));
    EXPECT_EQ(KeyOf(2.0F * cost) - KeyOf(cost), KeysOfOctave);
    EXPECT_LE(KeyOf(cost), KeyOf(static_cast<float>(cost * random.Between(1.0, 1.1))));
  }
}

TEST(CostKeys, AreCountedHoweverManyThereAre)
{
  constexpr CostKey limit = 0x8000;
  Random random(7);
  std::vector<CostKey> keys(200000);
  std::vector<Index> lower(keys.size() + 1, 0);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    keys[i] = static_cast<CostKey>(random.Between(0.0, limit + 100.0));
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
