// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundingTree.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace bonedecimate
{
namespace
{
constexpr Index Width = 4; // children of a node
/// Boxes are enlarged by this fraction of the whole and of the coordinate: four times the rounding
/// of single precision.
constexpr double Growth = 1.0 / (1 << 22);
/// Coordinates are clamped to this, in lengths of the whole, so that squares stay finite;
/// all boxes are equally far then.
constexpr double Far = 1e12;
constexpr double MinLength = 1e-290; // mm; the scale of a smaller surface would overflow

struct Range
{
  Index First, Last;
  Index Count() const { return this->Last - this->First; }
};

/// The centroid of a triangle.
struct Middle
{
  std::array<float, 3> At;
  Index Id;
};

/// The two halves of the range, or the range and an empty one if it fits into one node.
std::array<Range, 2> Halve(Middle* middles, const Range& range)
{
  if (range.Count() <= Width)
  {
    return { range, Range{ range.Last, range.Last } };
  }
  std::array<float, 3> low = middles[range.First].At;
  std::array<float, 3> high = low;
  for (Index i = range.First + 1; i < range.Last; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], middles[i].At[axis]);
      high[axis] = std::max(high[axis], middles[i].At[axis]);
    }
  }
  const auto length = [&](std::size_t axis) { return high[axis] - low[axis]; };
  std::size_t axis = length(1) > length(0) ? 1 : 0;
  axis = length(2) > length(axis) ? 2 : axis;
  const Index half = (range.Count() / 2 + Width - 1) / Width * Width;
  const Index middle = range.First + half;
  std::nth_element(middles + range.First, middles + middle, middles + range.Last,
    [axis](const Middle& a, const Middle& b)
    { return a.At[axis] != b.At[axis] ? a.At[axis] < b.At[axis] : a.Id < b.Id; });
  return { Range{ range.First, middle }, Range{ middle, range.Last } };
}
}

//------------------------------------------------------------------------------
class BoundingTree::Builder
{
public:
  Builder(const Surface& surface, int threads, BoundingTree& tree)
    : Source(surface)
    , Threads(threads)
    , Tree(tree)
    , Middles(surface.Triangles.size())
  {
  }

  void Run(const std::function<void()>& afterStep)
  {
    this->Tree.SetUnit(this->Source);
    this->FindMiddles();
    this->Tree.Nodes.reserve(this->Middles.size() / 2 + 1);
    std::vector<std::size_t> levels = { 0 };
    for (std::vector<Range> ranges = { { 0, static_cast<Index>(this->Middles.size()) } };
         !ranges.empty();)
    {
      ranges = this->AddLevel(ranges);
      levels.push_back(this->Tree.Nodes.size());
      afterStep();
    }
    this->FillSlots();
    afterStep();
    this->Middles = {};
    this->Bundles.resize(this->Tree.Nodes.size());
    for (std::size_t level = levels.size() - 1; level-- > 0;)
    {
      const std::size_t first = levels[level];
      ForEachId(levels[level + 1] - first, this->Threads,
        [&](std::size_t i)
        {
          this->Tree.Bound(this->Tree.Nodes[first + i]);
          this->FillBundle(first + i);
        });
    }
    this->TakeBoxes();
  }

private:
  /// The triangles below a node.
  struct Bundle
  {
    Range Slots = { std::numeric_limits<Index>::max(), 0 };
    Vector3 LongestEdge = Vector3::Zero(); // mm
    Vector3 Area = Vector3::Zero();        // mm^2
    std::unique_ptr<OrientedBox> Box;      // if it is thin

    void Add(const Bundle& other)
    {
      this->Slots = { std::min(this->Slots.First, other.Slots.First),
        std::max(this->Slots.Last, other.Slots.Last) };
      this->Area += other.Area;
      this->AddEdge(other.LongestEdge);
    }
    void AddEdge(const Vector3& edge)
    {
      this->LongestEdge =
        edge.squaredNorm() > this->LongestEdge.squaredNorm() ? edge : this->LongestEdge;
    }
  };

  Bundle BundleOf(Index slot) const
  {
    const Triangle& corners = this->Tree.Slots[slot].Corners;
    const Vector3& a = this->Tree.Points[corners[0]];
    const Vector3& b = this->Tree.Points[corners[1]];
    const Vector3& c = this->Tree.Points[corners[2]];
    Bundle bundle = { { slot, slot + 1 }, b - a, AreaVector(a, b, c), {} };
    bundle.AddEdge(c - b);
    bundle.AddEdge(a - c);
    return bundle;
  }

  /// Needles as long as half of the box along the axes may have a better one.
  void FillBundle(std::size_t at)
  {
    const Node& node = this->Tree.Nodes[at];
    Bundle& bundle = this->Bundles[at];
    for (const Index child : node.Children)
    {
      if (child < 0)
      {
        bundle.Add(this->BundleOf(~child));
      }
      else if (child > 0)
      {
        bundle.Add(this->Bundles[child]);
      }
    }
    double squared = 0.0; // of the diagonal of the box, in the unit of the tree
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double length = *std::max_element(node.High[axis].begin(), node.High[axis].end()) -
        *std::min_element(node.Low[axis].begin(), node.Low[axis].end());
      squared += length * length;
    }
    const double scale = this->Tree.Scale;
    if (4.0 * bundle.LongestEdge.squaredNorm() * scale * scale > squared)
    {
      OrientedBox box(bundle.LongestEdge, bundle.Area,
        [&](const auto& add)
        {
          for (Index slot = bundle.Slots.First; slot < bundle.Slots.Last; ++slot)
          {
            for (const Index corner : this->Tree.Slots[slot].Corners)
            {
              add(this->Tree.Points[corner]);
            }
          }
        });
      bundle.Box = box.IsThin() ? std::make_unique<OrientedBox>(box) : nullptr;
    }
  }

  void TakeBoxes()
  {
    for (std::size_t i = 0; i < this->Bundles.size(); ++i)
    {
      if (this->Bundles[i].Box)
      {
        this->Tree.Nodes[i].Box = static_cast<Index>(this->Tree.Boxes.size());
        this->Tree.Boxes.push_back(*this->Bundles[i].Box);
      }
    }
    for (Node& node : this->Tree.Nodes)
    {
      for (std::size_t child = 0; child < 4; ++child)
      {
        const Index at = node.Children[child];
        node.HasBox |= at > 0 && this->Tree.Nodes[at].Box != None ? 1U << child : 0U;
      }
    }
  }

  void FindMiddles()
  {
    ForEachId(this->Middles.size(), this->Threads,
      [&](std::size_t t)
      {
        const Triangle& c = this->Source.Triangles[t];
        const std::vector<Vector3>& p = this->Source.Points;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
        {
          const double sum = p[c[0]][axis] + p[c[1]][axis] + p[c[2]][axis];
          this->Middles[t].At[static_cast<std::size_t>(axis)] =
            this->Tree.ToUnit(sum / 3.0, axis, 0.0);
        }
        this->Middles[t].Id = static_cast<Index>(t);
      });
  }

  std::vector<Range> HalveAll(const std::vector<Range>& ranges)
  {
    std::vector<Range> halves(2 * ranges.size());
    ForEachChunk(ranges.size(), this->Threads, Monitor(),
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          const std::array<Range, 2> two = Halve(this->Middles.data(), ranges[i]);
          halves[2 * i] = two[0];
          halves[2 * i + 1] = two[1];
        }
      });
    return halves;
  }

  /// Sorts, because nth_element leaves the order within its halves to the standard library.
  void SortLeaves(const std::vector<Range>& ranges)
  {
    ForEachId(ranges.size(), this->Threads,
      [&](std::size_t i)
      {
        if (ranges[i].Count() <= Width)
        {
          std::sort(this->Middles.begin() + ranges[i].First, this->Middles.begin() + ranges[i].Last,
            [](const Middle& a, const Middle& b) { return a.Id < b.Id; });
        }
      });
  }

  /// Adds a node for each range; returns the ranges of the nodes of the next level.
  std::vector<Range> AddLevel(const std::vector<Range>& ranges)
  {
    const std::vector<Range> quarters = this->HalveAll(this->HalveAll(ranges));
    this->SortLeaves(ranges);
    const std::size_t nextLevel = this->Tree.Nodes.size() + ranges.size();
    std::vector<Range> next;
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      Node node;
      for (std::size_t child = 0; child < 4; ++child)
      {
        const Range& quarter = quarters[4 * i + child];
        const Index slot = ranges[i].First + static_cast<Index>(child);
        const bool isLast = ranges[i].Count() <= Width;
        const bool isThere = isLast ? slot < ranges[i].Last : quarter.Count() > 0;
        node.Children[child] = !isThere ? 0 // the root, which is never a child
          : isLast                      ? ~slot
                                        : static_cast<Index>(nextLevel + next.size());
        if (isThere && !isLast)
        {
          next.push_back(quarter);
        }
      }
      this->Tree.Nodes.push_back(node);
    }
    return next;
  }

  void FillSlots()
  {
    this->Tree.Points = this->Source.Points;
    this->Tree.Slots.resize(this->Middles.size());
    this->Tree.SlotOfTriangle.resize(this->Middles.size());
    ForEachId(this->Middles.size(), this->Threads,
      [&](std::size_t slot)
      {
        const Index id = this->Middles[slot].Id;
        this->Tree.Slots[slot] = { this->Source.Triangles[id], id };
        this->Tree.SlotOfTriangle[id] = static_cast<Index>(slot);
      });
  }

  const Surface& Source;
  int Threads;
  BoundingTree& Tree;
  std::vector<Middle> Middles; // by slot
  std::vector<Bundle> Bundles; // by node
};

//------------------------------------------------------------------------------
BoundingTree::BoundingTree(
  const Surface& surface, int threads, const std::function<void()>& afterStep)
{
  if (!surface.Triangles.empty())
  {
    Builder(surface, threads, *this).Run(afterStep ? afterStep : [] {});
  }
}

//------------------------------------------------------------------------------
void BoundingTree::SetUnit(const Surface& surface)
{
  this->Low = surface.Points[surface.Triangles[0][0]];
  Vector3 high = this->Low;
  for (const Triangle& corners : surface.Triangles)
  {
    for (const Index corner : corners)
    {
      this->Low = this->Low.cwiseMin(surface.Points[corner]);
      high = high.cwiseMax(surface.Points[corner]);
    }
  }
  this->Scale = 1.0 / std::max(MinLength, (high - this->Low).maxCoeff());
}

//------------------------------------------------------------------------------
/// Converts mm to a unit in which all triangles lie between 0 and 1, rounded safely down (side -1)
/// or up (side 1).
float BoundingTree::ToUnit(double coordinate, Eigen::Index axis, double side) const
{
  const double unit = std::clamp((coordinate - this->Low[axis]) * this->Scale, -Far, Far);
  return static_cast<float>(unit + side * Growth * (std::abs(unit) + 1.0));
}

//------------------------------------------------------------------------------
void BoundingTree::Bound(Node& node) const
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (std::size_t child = 0; child < 4; ++child)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto along = static_cast<Eigen::Index>(axis);
      float& low = node.Low[axis][child] = infinity;
      float& high = node.High[axis][child] = -infinity;
      if (node.Children[child] < 0)
      {
        const Triangle& corners = this->Slots[~node.Children[child]].Corners;
        const Vector3& a = this->Points[corners[0]];
        const Vector3& b = this->Points[corners[1]];
        const Vector3& c = this->Points[corners[2]];
        low = this->ToUnit(std::min({ a[along], b[along], c[along] }), along, -1.0);
        high = this->ToUnit(std::max({ a[along], b[along], c[along] }), along, 1.0);
      }
      else if (node.Children[child] > 0)
      {
        const Node& inner = this->Nodes[node.Children[child]];
        low = *std::min_element(inner.Low[axis].begin(), inner.Low[axis].end());
        high = *std::max_element(inner.High[axis].begin(), inner.High[axis].end());
      }
    }
  }
}
}
