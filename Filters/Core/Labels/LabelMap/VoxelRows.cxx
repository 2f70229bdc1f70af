// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelRows.h"

#include "Base/Parallel.h"
#include "Geometry/ExactPredicates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace bonedecimate
{
namespace
{
/// In voxels. A surface that is farther away does not belong to the grid.
constexpr double Farthest = 1e6;

std::int64_t FloorOf(double voxels)
{
  return static_cast<std::int64_t>(std::floor(std::clamp(voxels, -Farthest, Farthest)));
}

std::int64_t CeilOf(double voxels)
{
  return -FloorOf(-voxels);
}

/// What the edge from a to b adds to the winding number of a projected triangle around p.
int WindingOf(const Vector3& a, const Vector3& b, const Vector3& p)
{
  if (a[2] <= p[2] && p[2] < b[2])
  {
    return ProjectedOrientation(a, b, p, 0) > 0 ? 1 : 0;
  }
  if (b[2] <= p[2] && p[2] < a[2])
  {
    return ProjectedOrientation(b, a, p, 0) > 0 ? -1 : 0;
  }
  return 0;
}

/// The lowest voxel center along the first axis that is above the triangle or on it.
/// @param sign Sign of the first coordinate of the normal.
std::int64_t FirstAbove(const std::array<Vector3, 3>& corners, Vector3 p, int sign)
{
  const OrientedPlane plane(corners[0], corners[1], corners[2]);
  std::int64_t low = CeilOf(std::min({ corners[0][0], corners[1][0], corners[2][0] }));
  std::int64_t high = FloorOf(std::max({ corners[0][0], corners[1][0], corners[2][0] })) + 1;
  while (low < high)
  {
    const std::int64_t middle = low + (high - low) / 2;
    p[0] = static_cast<double>(middle);
    const bool isBelow = sign * plane.SideOf(p) < 0;
    (isBelow ? low : high) = isBelow ? middle + 1 : middle;
  }
  return low;
}

bool Less(const Vector3& a, const Vector3& b)
{
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

/// A number for each point, the same for equal coordinates.
std::vector<Index> NumbersOfPositions(const std::vector<Vector3>& points)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [&](Index a, Index b) { return Less(points[a], points[b]); });
  std::vector<Index> numbers(points.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    numbers[order[i]] =
      numbers[order[i - 1]] + (Less(points[order[i - 1]], points[order[i]]) ? 1 : 0);
  }
  return numbers;
}

/// The label before the first crossing of a row; None if all crossings cancel. Those between the
/// same two voxels have no order: the first ones that do not cancel lead out of this label.
template <typename Crossing>
Index FirstLabel(const std::vector<Crossing>& all, std::size_t first)
{
  std::map<Index, int> sums; // crossings out of each label minus into it
  for (std::size_t i = first; i < all.size() && all[i].Row == all[first].Row; ++i)
  {
    ++sums[all[i].Labels[0]];
    --sums[all[i].Labels[1]];
    const bool hasMore = i + 1 < all.size() &&
      std::tie(all[i].Row, all[i].Above) == std::tie(all[i + 1].Row, all[i + 1].Above);
    const auto out =
      std::find_if(sums.begin(), sums.end(), [](const auto& sum) { return sum.second > 0; });
    if (!hasMore && out != sums.end())
    {
      return out->first;
    }
  }
  return None;
}
}

bool HasBoundary(const Surface& surface)
{
  const std::vector<Index> numbers = NumbersOfPositions(surface.Points);
  // The larger ends of all edges, in groups of equal smaller ends.
  const auto visitEdges = [&](const auto& visit)
  {
    for (const Triangle& c : surface.Triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto [low, high] = std::minmax({ numbers[c[i]], numbers[c[(i + 1) % 3]] });
        visit(static_cast<std::size_t>(low), high);
      }
    }
  };
  std::vector<std::size_t> ends(surface.Points.size() + 1, 0);
  visitEdges([&](std::size_t low, Index) { ++ends[low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Index> others(ends.back());
  visitEdges([&](std::size_t low, Index high) { others[ends[low]++] = high; });
  for (std::size_t low = 0, first = 0; low < surface.Points.size(); first = ends[low++])
  {
    const auto begin = others.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(ends[low]);
    std::sort(begin, end);
    for (auto other = begin; other != end;)
    {
      const auto next = std::upper_bound(other, end, *other);
      if (next - other == 1 && *other != static_cast<Index>(low))
      {
        return true;
      }
      other = next;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
VoxelRows::VoxelRows(
  const LabeledSurface& surface, const VoxelGrid& grid, Index background, int threads)
  : Triangles(surface.Surface.Triangles)
  , Labels(surface.Labels)
  , Background(background)
  , IsMirrored(grid.Direction.determinant() < 0.0)
  , Grid(grid)
  , Points(surface.Surface.Points.size())
{
  ForEachId(this->Points.size(), threads,
    [&](std::size_t p) { this->Points[p] = grid.ToSteps(surface.Surface.Points[p]); });
  Vector3 low = Vector3::Constant(Farthest);
  Vector3 high = -low;
  for (const Triangle& c : this->Triangles)
  {
    for (const Index p : c)
    {
      low = low.cwiseMin(this->Points[p]);
      high = high.cwiseMax(this->Points[p]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Low[k] = FloorOf(low[static_cast<Eigen::Index>(k)]);
    this->High[k] = CeilOf(high[static_cast<Eigen::Index>(k)]);
  }
  if (grid.HasLayers())
  {
    this->Low[2] = grid.LastLayerAtOrBelow(std::clamp(low[2], -Farthest, Farthest));
    this->High[2] = grid.FirstLayerAtOrAbove(std::clamp(high[2], -Farthest, Farthest));
  }
  this->SortIntoSlices();
}

//------------------------------------------------------------------------------
/// The first slice, from Low, that the triangle may meet, and one past the last.
std::array<std::int64_t, 2> VoxelRows::SlicesOf(const Triangle& c) const
{
  const auto [least, largest] =
    std::minmax({ this->Points[c[0]][2], this->Points[c[1]][2], this->Points[c[2]][2] });
  const bool hasLayers = this->Grid.HasLayers();
  const std::int64_t first = hasLayers
    ? this->Grid.FirstLayerAtOrAbove(std::clamp(least, -Farthest, Farthest))
    : CeilOf(least);
  const std::int64_t last = hasLayers
    ? this->Grid.LastLayerAtOrBelow(std::clamp(largest, -Farthest, Farthest))
    : FloorOf(largest);
  return { first - this->Low[2], last - this->Low[2] + 1 };
}

//------------------------------------------------------------------------------
void VoxelRows::SortIntoSlices()
{
  const std::int64_t slices = std::max<std::int64_t>(0, this->High[2] - this->Low[2] + 1);
  this->Starts.assign(static_cast<std::size_t>(slices) + 1, 0);
  for (const Triangle& c : this->Triangles)
  {
    const auto range = this->SlicesOf(c);
    for (std::int64_t z = range[0]; z < range[1]; ++z)
    {
      ++this->Starts[static_cast<std::size_t>(z) + 1];
    }
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  this->InSlice.resize(this->Starts.back());
  std::vector<std::size_t> next = this->Starts;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const auto range = this->SlicesOf(this->Triangles[t]);
    for (std::int64_t z = range[0]; z < range[1]; ++z)
    {
      this->InSlice[next[static_cast<std::size_t>(z)]++] = static_cast<Index>(t);
    }
  }
}

//------------------------------------------------------------------------------
VoxelBox VoxelRows::Bounds() const
{
  VoxelBox box;
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.First[k] = this->Low[k];
    box.Count[k] = std::max<std::int64_t>(0, this->High[k] - this->Low[k] + 1);
  }
  return box;
}

//------------------------------------------------------------------------------
VoxelRows::Slice::Slice(const VoxelRows& rows, const VoxelBox& box)
  : Rows(rows)
  , Box(box)
{
}

//------------------------------------------------------------------------------
void VoxelRows::Slice::Begin(std::int64_t z)
{
  this->Crossings.clear();
  this->Next = 0;
  const std::int64_t slice = z + this->Box.First[2];
  if (slice >= this->Rows.Low[2] && slice <= this->Rows.High[2])
  {
    const std::size_t at = static_cast<std::size_t>(slice - this->Rows.Low[2]);
    for (std::size_t i = this->Rows.Starts[at]; i < this->Rows.Starts[at + 1]; ++i)
    {
      this->Cross(this->Rows.InSlice[i], slice);
    }
  }
  std::sort(this->Crossings.begin(), this->Crossings.end(),
    [](const Crossing& a, const Crossing& b)
    { return std::tie(a.Row, a.Above, a.Labels) < std::tie(b.Row, b.Above, b.Labels); });
}

//------------------------------------------------------------------------------
void VoxelRows::Slice::Cross(Index triangle, std::int64_t z)
{
  const Triangle& c = this->Rows.Triangles[triangle];
  const std::array<Vector3, 3> corners = { this->Rows.Points[c[0]], this->Rows.Points[c[1]],
    this->Rows.Points[c[2]] };
  static constexpr BoundaryLabels single = { 0, 1 };
  const BoundaryLabels& labels = this->Rows.Labels.empty() ? single : this->Rows.Labels[triangle];
  const std::int64_t first = CeilOf(std::min({ corners[0][1], corners[1][1], corners[2][1] }));
  const std::int64_t last = FloorOf(std::max({ corners[0][1], corners[1][1], corners[2][1] }));
  const double height = this->Rows.Grid.StepsOf(static_cast<double>(z));
  for (std::int64_t y = first; y <= last; ++y)
  {
    const Vector3 p(0.0, static_cast<double>(y), height);
    const int winding = WindingOf(corners[0], corners[1], p) +
      WindingOf(corners[1], corners[2], p) + WindingOf(corners[2], corners[0], p);
    if (winding != 0)
    {
      const bool isForward = (winding > 0) != this->Rows.IsMirrored;
      const std::int64_t above = FirstAbove(corners, p, winding) - this->Box.First[0];
      this->Crossings.push_back(
        { y - this->Box.First[1], std::clamp<std::int64_t>(above, 0, this->Box.Count[0]),
          { labels[isForward ? 0 : 1], labels[isForward ? 1 : 0] } });
    }
  }
}

//------------------------------------------------------------------------------
void VoxelRows::Slice::Add(Index label, int number)
{
  for (Count& count : this->Counts)
  {
    if (count.Label == label)
    {
      count.Number += number;
      return;
    }
  }
  this->Counts.push_back({ label, number });
}

//------------------------------------------------------------------------------
Index VoxelRows::Slice::Current() const
{
  Index current = Ambiguous;
  for (const Count& count : this->Counts)
  {
    if (count.Number != 0)
    {
      const bool isOnly = current == Ambiguous && count.Number == 1;
      if (!isOnly)
      {
        return Ambiguous;
      }
      current = count.Label;
    }
  }
  return current;
}

//------------------------------------------------------------------------------
void VoxelRows::Slice::Row(std::int64_t y, bool isOpen, std::vector<Index>& labels)
{
  labels.assign(static_cast<std::size_t>(this->Box.Count[0]), None);
  const std::vector<Crossing>& all = this->Crossings;
  while (this->Next < all.size() && all[this->Next].Row < y)
  {
    ++this->Next;
  }
  if (this->Next == all.size() || all[this->Next].Row != y)
  {
    return;
  }
  const Index before = isOpen ? FirstLabel(all, this->Next) : this->Rows.Background;
  if (before == None)
  {
    return;
  }
  this->Counts.clear();
  this->Add(before, 1);
  std::size_t x = 0;
  for (; this->Next < all.size() && all[this->Next].Row == y; ++this->Next)
  {
    const Crossing& crossing = all[this->Next];
    const std::size_t end = static_cast<std::size_t>(crossing.Above);
    std::fill(labels.begin() + static_cast<std::ptrdiff_t>(x),
      labels.begin() + static_cast<std::ptrdiff_t>(end), this->Current());
    x = end;
    this->Add(crossing.Labels[0], -1);
    this->Add(crossing.Labels[1], 1);
  }
  std::fill(labels.begin() + static_cast<std::ptrdiff_t>(x), labels.end(), this->Current());
}
}
