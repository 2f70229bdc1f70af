// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AxisCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
namespace
{
/// Rounding of this search and of the programs that copied the map; in layers.
constexpr double Tolerance = 1e-6;
/// Ways of rounding in the same direction for all even boundaries, and for all odd ones.
constexpr double ConsistentTies = 4.0;
constexpr std::size_t MaxRegions = 20000;
constexpr std::size_t MaxConsidered = 64; // regions
constexpr double MuchLess = 0.1;          // ratio of chances

struct Line
{
  double Boundary;
  double Length;
};

/// Lines that explain the changes so far, the last one by boundary number Last.
struct Region
{
  std::vector<Line> Corners;
  double LastBoundary = 0.0;
};

/// The part of a polygon where excess(corner) <= 0; excess is linear.
template <typename Excess>
std::vector<Line> Cut(const std::vector<Line>& corners, const Excess& excess)
{
  std::vector<Line> kept;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Line& a = corners[i];
    const Line& b = corners[(i + 1) % corners.size()];
    const double atA = excess(a);
    const double atB = excess(b);
    if (atA <= 0.0)
    {
      kept.push_back(a);
    }
    if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))
    {
      const double ratio = atA / (atA - atB);
      kept.push_back({ a.Boundary + ratio * (b.Boundary - a.Boundary),
        a.Length + ratio * (b.Length - a.Length) });
    }
  }
  return kept;
}

/// Adds the parts of the region that explain a change, each by one boundary.
void ExplainChange(const Region& region, double layer, double tolerance, std::vector<Region>& parts)
{
  double first = MaxCoordinate;
  double last = region.LastBoundary;
  for (const Line& corner : region.Corners)
  {
    first = std::min(first, (layer - 1.0 - tolerance - corner.Boundary) / corner.Length);
    last = std::max(last, (layer + tolerance - corner.Boundary) / corner.Length);
  }
  first = std::max(region.LastBoundary + 1.0, std::ceil(first));
  for (double boundary = first; boundary <= last && parts.size() < MaxRegions; boundary += 1.0)
  {
    const auto position = [boundary](const Line& line)
    { return line.Boundary + boundary * line.Length; };
    std::vector<Line> corners =
      Cut(region.Corners, [&](const Line& line) { return position(line) - layer - tolerance; });
    corners =
      Cut(corners, [&](const Line& line) { return layer - 1.0 - tolerance - position(line); });
    if (!corners.empty())
    {
      parts.push_back({ std::move(corners), boundary });
    }
  }
}

/// All regions that explain all changes; none if they become too many.
/// @param tolerance Negative: without boundaries at centers of layers.
std::vector<Region> ExplainChanges(
  const std::vector<Index>& changes, const CellLengths& lengths, double tolerance)
{
  const double first = changes.front() - 1.0 - tolerance;
  const double last = changes.front() + tolerance;
  std::vector<Region> regions = { { { { first, lengths.Min }, { last, lengths.Min },
                                      { last, lengths.Max }, { first, lengths.Max } },
    0.0 } };
  for (std::size_t i = 1; i < changes.size() && !regions.empty(); ++i)
  {
    std::vector<Region> parts;
    for (const Region& region : regions)
    {
      ExplainChange(region, changes[i], tolerance, parts);
    }
    regions = parts.size() < MaxRegions ? std::move(parts) : std::vector<Region>();
  }
  return regions;
}

/**
 * The number of ways in which boundaries at centers of layers can be rounded; 0 if the line does
 * not explain the changes. Programs round all in one direction or to even samples. Where their
 * quotients are not exact, each boundary is rounded in its own direction.
 */
double RoundingsOf(const Line& line, const std::vector<Index>& changes)
{
  double last = -MaxCoordinate;
  double roundings = 1.0;
  std::array<int, 2> direction = { 0, 0 }; // of even and of odd boundaries
  bool isConsistent = true;
  for (const Index layer : changes)
  {
    const double boundary = std::floor((layer + Tolerance - line.Boundary) / line.Length);
    const double position = line.Boundary + boundary * line.Length - layer; // -1 to 0
    if (boundary <= last || position < -1.0 - Tolerance)
    {
      return 0.0;
    }
    last = boundary;
    const int side = position <= -1.0 + Tolerance ? -1 : position >= -Tolerance ? 1 : 0;
    int& usual = direction[static_cast<std::size_t>(boundary - 2.0 * std::floor(boundary / 2.0))];
    isConsistent = isConsistent && (side == 0 || usual == 0 || usual == side);
    usual = side == 0 ? usual : side;
    roundings *= side == 0 ? 1.0 : 2.0;
  }
  return isConsistent ? ConsistentTies : std::max(roundings, ConsistentTies);
}

/// Marks layers before which there is a boundary. A boundary at the center of a layer is before or
/// behind it, wherever labels change.
std::vector<bool> BoundaryPlanes(const Line& line, const std::vector<Index>& changes, Index layers)
{
  std::vector<bool> isBoundary(static_cast<std::size_t>(layers), false);
  const auto changesAt = [&](double layer)
  { return std::binary_search(changes.begin(), changes.end(), static_cast<Index>(layer)); };
  double boundary = std::ceil(-line.Boundary / line.Length - 1.0);
  for (;; boundary += 1.0)
  {
    const double position = line.Boundary + boundary * line.Length;
    const double nearest = std::floor(position + 0.5);
    const bool isCenter = std::abs(position - nearest) <= 2.0 * Tolerance;
    const double layer = !isCenter                      ? std::ceil(position)
      : changesAt(nearest + 1.0) && !changesAt(nearest) ? nearest + 1.0
                                                        : nearest;
    if (layer >= layers)
    {
      return isBoundary;
    }
    if (layer >= 1.0)
    {
      isBoundary[static_cast<std::size_t>(layer)] = true;
    }
  }
}

/**
 * An upper bound: the number of sets of boundaries, with the first and the last change at its ends,
 * times the probability that all other changes lie on boundaries of one of them
 * (Documentation/explanation/model-grid.md).
 */
double ChanceOf(
  const std::vector<Index>& changes, const std::vector<bool>& isBoundary, double roundings)
{
  const double between = changes.back() - changes.front() - 1.0;
  const double boundaries = static_cast<double>(std::count(
    isBoundary.begin() + changes.front() + 1, isBoundary.begin() + changes.back(), true));
  double chance = roundings * (between + 1.0) * (between + 2.0) * (between + 3.0) / 6.0;
  for (std::size_t i = 0; i + 2 < changes.size(); ++i)
  {
    const auto placed = static_cast<double>(i);
    chance *= (boundaries - placed) / (between - placed);
  }
  return std::min(1.0, chance);
}

/// The line with the least chance; the first of several that hardly differ.
class BestLine
{
public:
  BestLine(const std::vector<Index>& changes, Index layers)
    : Changes(changes)
    , Layers(layers)
  {
  }

  void Consider(const Line& line)
  {
    const double roundings = RoundingsOf(line, this->Changes);
    if (roundings > 0.0)
    {
      std::vector<bool> isBoundary = BoundaryPlanes(line, this->Changes, this->Layers);
      const double chance = ChanceOf(this->Changes, isBoundary, roundings);
      if (this->IsBoundary.empty() || chance < MuchLess * this->Chance)
      {
        this->Best = line;
        this->Chance = chance;
        this->IsBoundary = std::move(isBoundary);
      }
    }
  }

  std::optional<AxisCells> Cells() const
  {
    if (this->IsBoundary.empty())
    {
      return std::nullopt;
    }
    AxisCells cells;
    Index cell = 0;
    for (const bool isNext : this->IsBoundary)
    {
      cell += isNext ? 1 : 0;
      cells.OfLayer.push_back(cell);
    }
    // The boundary that explains the first change is that before its cell.
    const Index first = this->Changes.front();
    const double boundary =
      std::floor((first + Tolerance - this->Best.Boundary) / this->Best.Length);
    cells.Length = this->Best.Length;
    cells.FirstSample = this->Best.Boundary +
      (boundary + 0.5 - cells.OfLayer[static_cast<std::size_t>(first)]) * this->Best.Length;
    cells.Chance = this->Chance;
    return cells;
  }

private:
  const std::vector<Index>& Changes;
  Index Layers;
  Line Best = { 0.0, 1.0 };
  double Chance = 1.0;
  std::vector<bool> IsBoundary;
};

/**
 * Considers cells as programs make them that copy a whole map of m samples to n layers, the
 * coarsest first:
 *
 *     corners aligned        layer i has the sample nearest to i (m - 1) / (n - 1)
 *     centers aligned        layer i has the sample nearest to (i + 1/2) m / n - 1/2
 *     first center aligned   layer i has the sample nearest to i / Length, for usual lengths
 */
void ConsiderUsualCells(Index layers, const CellLengths& lengths, BestLine& best)
{
  const auto consider = [&](double first, const auto& lineOf)
  {
    double number = first;
    for (Line line = lineOf(number); line.Length >= lengths.Min; line = lineOf(++number))
    {
      if (line.Length <= lengths.Max + Tolerance)
      {
        best.Consider(line);
      }
    }
  };
  const double samples = std::max(2.0, std::floor((layers - 1.0) / lengths.Max));
  const auto fromCenter = [](double length) { return Line{ length / 2.0, length }; };
  consider(samples, [&](double m) { return fromCenter((layers - 1.0) / (m - 1.0)); });
  consider(samples, [&](double m) { return Line{ layers / m - 0.5, layers / m }; });
  if (lengths.UsualStep > 0.0)
  {
    const double most = std::floor(lengths.Max / lengths.UsualStep);
    consider(0.0, [&](double m) { return fromCenter((most - m) * lengths.UsualStep); });
  }
}

Line MeanOf(const std::vector<Line>& corners)
{
  Line mean = { 0.0, 0.0 };
  for (const Line& corner : corners)
  {
    mean.Boundary += corner.Boundary / static_cast<double>(corners.size());
    mean.Length += corner.Length / static_cast<double>(corners.size());
  }
  return mean;
}

double LongestOf(const Region& region)
{
  return std::max_element(region.Corners.begin(), region.Corners.end(),
    [](const Line& a, const Line& b) { return a.Length < b.Length; })
    ->Length;
}

/// Considers the middles of the coarsest regions.
void ConsiderRegions(std::vector<Region> regions, BestLine& best)
{
  std::stable_sort(regions.begin(), regions.end(),
    [](const Region& a, const Region& b) { return LongestOf(a) > LongestOf(b); });
  for (std::size_t i = 0; i < std::min(regions.size(), MaxConsidered); ++i)
  {
    best.Consider(MeanOf(regions[i].Corners));
  }
}
}

AxisCells CellsOfLayers(Index layers)
{
  AxisCells cells;
  cells.OfLayer.resize(static_cast<std::size_t>(layers));
  std::iota(cells.OfLayer.begin(), cells.OfLayer.end(), 0);
  return cells;
}

std::optional<AxisCells> FindAxisCells(
  const std::vector<Index>& changes, Index layers, const CellLengths& lengths)
{
  if (changes.size() < 2)
  {
    return std::nullopt;
  }
  // Neighboring changes have different boundaries, which limits the length. Cells hardly longer
  // than a layer would have a boundary before each layer.
  double longest = lengths.Max > 0.0 ? lengths.Max : layers;
  for (std::size_t i = 1; i < changes.size(); ++i)
  {
    longest = std::min(longest, changes[i] - changes[i - 1] + 1.0 + 2.0 * Tolerance);
  }
  const double shortest = std::max(lengths.Min, 1.0 + 1.0 / layers);
  if (longest < shortest)
  {
    return std::nullopt;
  }
  const CellLengths range = { shortest, longest, lengths.UsualStep };
  BestLine best(changes, layers);
  ConsiderUsualCells(layers, range, best);
  ConsiderRegions(ExplainChanges(changes, range, -Tolerance), best);
  ConsiderRegions(ExplainChanges(changes, range, Tolerance), best);
  return best.Cells();
}
}
