// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelRanks.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <unordered_set>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MaxTableSize = std::size_t(1) << 20U;
constexpr std::size_t VoxelsPerPart = std::size_t(1) << 18U;

/// For types of up to two bytes: a flag for each value.
template <typename Scalar>
void FindInTable(const Scalar* values, std::size_t count, std::vector<Scalar>& found)
{
  using Unsigned = std::make_unsigned_t<Scalar>;
  std::vector<unsigned char> occurs(std::size_t(std::numeric_limits<Unsigned>::max()) + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    occurs[static_cast<Unsigned>(values[i])] = 1;
  }
  for (std::size_t value = 0; value < occurs.size(); ++value)
  {
    if (occurs[value] != 0)
    {
      found.push_back(static_cast<Scalar>(static_cast<Unsigned>(value)));
    }
  }
}

/// For other types: most voxels have the label of the one before.
template <typename Scalar>
void FindInSet(const Scalar* values, std::size_t count, std::vector<Scalar>& found)
{
  std::unordered_set<Scalar> set;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i == 0 || values[i] != values[i - 1])
    {
      set.insert(values[i]);
    }
  }
  found.assign(set.begin(), set.end());
}

template <typename Scalar>
void SortOnce(std::vector<Scalar>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <typename Scalar>
LabelValues Int64Values(const std::vector<Scalar>& values)
{
  LabelValues result;
  for (const Scalar value : values)
  {
    if (std::is_signed_v<Scalar> ||
      static_cast<std::uint64_t>(value) <=
        static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    {
      result.Values.push_back(static_cast<std::int64_t>(value));
    }
    else
    {
      result.FitInt64 = false;
    }
  }
  return result;
}

template <typename Scalar>
LabelValues FindValues(const Scalar* values, std::size_t count, int threads, const Monitor& monitor)
{
  std::vector<std::vector<Scalar>> found((count + VoxelsPerPart - 1) / VoxelsPerPart);
  const bool isComplete = ForEachPart(found.size(), threads, monitor,
    [&](std::size_t part)
    {
      const std::size_t first = part * VoxelsPerPart;
      const std::size_t size = std::min(count - first, VoxelsPerPart);
      if constexpr (sizeof(Scalar) <= 2)
      {
        FindInTable(values + first, size, found[part]);
      }
      else
      {
        FindInSet(values + first, size, found[part]);
      }
    });
  std::vector<Scalar> all;
  for (const std::vector<Scalar>& part : found)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  SortOnce(all);
  LabelValues result = Int64Values(all);
  result.IsComplete = isComplete;
  return result;
}
}

//------------------------------------------------------------------------------
LabelValues FindLabelValues(const LabelImage& image, int threads, const Monitor& monitor)
{
  return WithLabelsOf(image,
    [&](const auto* values)
    { return FindValues(values, image.Grid.NumberOfVoxels(), threads, monitor); });
}

//------------------------------------------------------------------------------
LabelRanks::LabelRanks(std::vector<std::int64_t> labels)
  : Labels(std::move(labels))
{
  if (this->Labels.empty())
  {
    return;
  }
  this->MinLabel = this->Labels.front();
  const std::uint64_t range =
    static_cast<std::uint64_t>(this->Labels.back()) - static_cast<std::uint64_t>(this->MinLabel);
  if (range < MaxTableSize)
  {
    this->Table.assign(range + 1, 0);
    for (std::size_t i = 0; i < this->Labels.size(); ++i)
    {
      this->Table[static_cast<std::size_t>(this->Labels[i] - this->MinLabel)] =
        static_cast<Index>(i + 1);
    }
  }
}

//------------------------------------------------------------------------------
Index LabelRanks::Find(std::int64_t value) const
{
  const auto found = std::lower_bound(this->Labels.begin(), this->Labels.end(), value);
  return found == this->Labels.end() || *found != value
    ? 0
    : static_cast<Index>(found - this->Labels.begin() + 1);
}

//------------------------------------------------------------------------------
template <typename Scalar>
void LabelRanks::ConvertValues(const Scalar* values, std::size_t count, Index* ranks) const
{
  // The conversion to int64 maps larger values to negative ones, which equal no label of an
  // unsigned map.
  const auto least = static_cast<std::uint64_t>(this->MinLabel);
  const bool isUnsigned = !std::is_signed_v<Scalar>;
  if (!this->Table.empty() && !(isUnsigned && this->MinLabel < 0))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint64_t entry = static_cast<std::uint64_t>(values[i]) - least;
      ranks[i] = entry < this->Table.size() ? this->Table[entry] : 0;
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto value = static_cast<std::int64_t>(static_cast<std::uint64_t>(values[i]));
    const bool fits = !isUnsigned || value >= 0;
    ranks[i] = i > 0 && values[i] == values[i - 1] ? ranks[i - 1] : fits ? this->Find(value) : 0;
  }
}

//------------------------------------------------------------------------------
void LabelRanks::Convert(
  const LabelImage& image, std::size_t first, std::size_t count, Index* ranks) const
{
  WithLabelsOf(
    image, [&](const auto* values) { this->ConvertValues(values + first, count, ranks); });
}
}
