// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/LargeArray.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

using namespace bonedecimate;

namespace
{
/// Bytes about the sizes at which large pages begin and end.
const std::vector<std::size_t> Sizes = { 1, 64, 1000, (1U << 20U) - 1, 1U << 20U, 3U << 19U,
  (1U << 21U) - 1, 1U << 21U, (3U << 20U) - 1, 3U << 20U, 5U << 20U };

struct alignas(64) Line
{
  std::uint8_t Bytes[64];
};
}

TEST(LargeArray, HoldsWhatIsWrittenWhateverItsSize)
{
  for (const std::size_t size : Sizes)
  {
    LargeArray<std::uint8_t> array(size);
    std::iota(array.begin(), array.end(), std::uint8_t(0));
    LargeArray<std::uint8_t> copy = array;
    copy.resize(2 * size, 7); // moves
    for (std::size_t i = 0; i < size; i += 1 + size / 1000)
    {
      ASSERT_EQ(copy[i], i % 256) << size;
    }
    EXPECT_EQ(copy[2 * size - 1], 7) << size;
  }
}

TEST(LargeArray, LiesOnCacheLines)
{
  for (const std::size_t size : Sizes)
  {
    const LargeArray<Line> array(size / sizeof(Line) + 1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % sizeof(Line), 0U) << size;
  }
}

TEST(LargeArray, FillsWithTheRequestedValueAndCallsConstructors)
{
  EXPECT_EQ(LargeArray<int>(3, -1), (LargeArray<int>{ -1, -1, -1 }));
  EXPECT_TRUE(LargeArray<std::vector<int>>(5)[4].empty());
}

TEST(LargeArray, ReservingLeavesAnOrdinaryVectorEmpty)
{
  for (const std::size_t size : Sizes)
  {
    std::vector<char> values;
    ReserveLarge(values, size);
    EXPECT_TRUE(values.empty());
    EXPECT_GE(values.capacity(), size);
    values.resize(size);
    EXPECT_EQ(values.back(), 0);
  }
}
