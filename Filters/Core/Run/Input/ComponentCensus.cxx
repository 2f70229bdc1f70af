// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComponentCensus.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/Statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bonedecimate
{
namespace
{
class Census
{
public:
  Census(const Surface& input, const CleanSurface& cleaned, const SharedPositions& shared)
    : Clean(cleaned)
    , Whole(FindComponents(cleaned.Surface))
  {
    this->Part.All.resize(static_cast<std::size_t>(this->Whole.Count));
    for (CensusOfPart::Component& component : this->Part.All)
    {
      component.Box = { Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity };
    }
    this->Shared.resize(cleaned.Surface.Points.size(), None);
    for (std::size_t p = 0; p < this->Shared.size() && !shared.empty(); ++p)
    {
      this->Shared[p] = Find(shared, input.Points[cleaned.InputPoint[p]]);
    }
  }

  void AddTriangles(const Vector3& origin)
  {
    const Vector3 shift = this->Clean.Origin - origin;
    for (const Triangle& c : this->Clean.Surface.Triangles)
    {
      const Index number = this->Whole.OfPoint[c[0]];
      CensusOfPart::Component& component = this->Part.All[number];
      const Vector3 a = this->Clean.Surface.Points[c[0]] + shift;
      const Vector3 area = AreaVector(
        a, this->Clean.Surface.Points[c[1]] + shift, this->Clean.Surface.Points[c[2]] + shift);
      ++component.Triangles;
      component.Area += area.norm();
      component.Volume += Dot(area, a) / 3.0;
      this->Part.OfTriangle.push_back(number);
    }
  }

  void AddPoints(const Vector3& origin)
  {
    const Vector3 shift = this->Clean.Origin - origin;
    for (std::size_t p = 0; p < this->Clean.Surface.Points.size(); ++p)
    {
      const Index number = this->Whole.OfPoint[p];
      const Vector3 position = this->Clean.Surface.Points[p] + shift;
      std::array<double, 6>& box = this->Part.All[number].Box;
      for (Eigen::Index axis = 0; axis < 3; ++axis)
      {
        box[axis] = std::min(box[axis], position[axis]);
        box[axis + 3] = std::max(box[axis + 3], position[axis]);
      }
      if (this->Shared[p] != None)
      {
        this->Part.Points.push_back({ this->Shared[p], number });
      }
    }
  }

  void AddEdges(int threads)
  {
    const std::vector<Triangle>& triangles = this->Clean.Surface.Triangles;
    const EdgeMatching matching(triangles, this->Clean.Surface.Points.size(), threads);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Index number = this->Part.OfTriangle[t];
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Index from = this->Shared[triangles[t][i]];
        const Index to = this->Shared[triangles[t][(i + 1) % 3]];
        if (from != None && to != None)
        {
          this->Part.Edges.push_back({ from, to, number });
        }
        else if (matching.Twins()[4 * t + i] < 0)
        {
          this->Part.All[number].IsOpen = true;
        }
      }
    }
  }

  CensusOfPart Part;

private:
  static Index Find(const SharedPositions& shared, const Vector3& p)
  {
    const std::array<double, 3> position = { p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 };
    const auto found = std::lower_bound(shared.begin(), shared.end(), position);
    return found != shared.end() && *found == position ? static_cast<Index>(found - shared.begin())
                                                       : None;
  }

  const CleanSurface& Clean;
  const Components Whole;
  std::vector<Index> Shared; // of each point
};

/// A disjoint-set forest over the components of all parts.
class Forest
{
public:
  explicit Forest(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  Index Root(Index i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

  /// The lesser root stays one.
  void Unite(Index a, Index b)
  {
    const Index first = this->Root(a);
    const Index second = this->Root(b);
    this->Parent[std::max(first, second)] = std::min(first, second);
  }

private:
  std::vector<Index> Parent;
};

/// An edge of shared positions in one of its triangles.
struct SharedEdge
{
  std::array<Index, 2> Ends; // ascending
  bool IsForward;
  Index Component;
};

/// Calls visit(first, last) for each group of elements with the same key; they are sorted by it.
template <typename T, typename KeyOf, typename Visit>
void ForEachGroup(std::vector<T>& elements, const KeyOf& keyOf, const Visit& visit)
{
  std::stable_sort(
    elements.begin(), elements.end(), [&](const T& a, const T& b) { return keyOf(a) < keyOf(b); });
  for (auto first = elements.begin(); first != elements.end();)
  {
    const auto last =
      std::find_if(first, elements.end(), [&](const T& e) { return keyOf(e) != keyOf(*first); });
    visit(first, last);
    first = last;
  }
}

/// Adds a component of a part to the whole one.  @param high Corner of its box; Center has
/// the low one until all are there.
void Add(const CensusOfPart::Component& part, PrunedComponent& whole, Vector3& high)
{
  whole.Triangles += part.Triangles;
  whole.Area += part.Area;
  whole.Volume += part.IsOpen ? std::numeric_limits<double>::quiet_NaN() : part.Volume;
  whole.Center = whole.Center.cwiseMin(Vector3(part.Box[0], part.Box[1], part.Box[2]));
  high = high.cwiseMax(Vector3(part.Box[3], part.Box[4], part.Box[5]));
}

/// Components of all parts, numbered one after the other.
struct AllParts
{
  std::vector<CensusOfPart::Component> Components;
  std::vector<std::array<Index, 2>> Points;
  std::vector<SharedEdge> Edges;

  explicit AllParts(const std::vector<CensusOfPart>& parts)
  {
    for (const CensusOfPart& part : parts)
    {
      const Index first = static_cast<Index>(this->Components.size());
      this->Components.insert(this->Components.end(), part.All.begin(), part.All.end());
      for (const auto& [position, component] : part.Points)
      {
        this->Points.push_back({ position, first + component });
      }
      for (const auto& [from, to, component] : part.Edges)
      {
        this->Edges.push_back(
          { { std::min(from, to), std::max(from, to) }, from < to, first + component });
      }
    }
  }

  Forest Join()
  {
    Forest forest(this->Components.size());
    ForEachGroup(
      this->Points, [](const std::array<Index, 2>& point) { return point[0]; },
      [&](auto first, auto last)
      {
        std::for_each(first, last,
          [&](const std::array<Index, 2>& point) { forest.Unite((*first)[1], point[1]); });
      });
    return forest;
  }

  /// An edge is closed by two triangles of opposite directions.
  void MarkOpen()
  {
    ForEachGroup(
      this->Edges, [](const SharedEdge& edge) { return edge.Ends; },
      [&](auto first, auto last)
      {
        const bool isClosed = last - first == 2 && first->IsForward != std::next(first)->IsForward;
        std::for_each(first, last,
          [&](const SharedEdge& edge) { this->Components[edge.Component].IsOpen |= !isClosed; });
      });
  }
};
}

CensusOfPart TakeCensus(const Surface& input, const CleanSurface& clean, const Vector3& origin,
  const SharedPositions& shared, int threads)
{
  Census census(input, clean, shared);
  census.AddTriangles(origin);
  census.AddPoints(origin);
  census.AddEdges(threads);
  return std::move(census.Part);
}

//------------------------------------------------------------------------------
CensusOfPart TakeCensus(
  const Surface& input, const Vector3& origin, const SharedPositions& shared, int threads)
{
  const CleanSurface clean = Clean(input, true, threads);
  if (clean.Status != InputStatus::Good)
  {
    return {};
  }
  CensusOfPart census = TakeCensus(input, clean, origin, shared, threads);
  std::vector<Index> ofInput(input.Triangles.size(), None);
  for (std::size_t t = 0; t < clean.InputTriangle.size(); ++t)
  {
    ofInput[static_cast<std::size_t>(clean.InputTriangle[t])] = census.OfTriangle[t];
  }
  census.OfTriangle = std::move(ofInput);
  return census;
}

//------------------------------------------------------------------------------
JoinedCensus JoinCensus(const std::vector<CensusOfPart>& parts, const Vector3& origin)
{
  AllParts all(parts);
  Forest forest = all.Join();
  all.MarkOpen();
  JoinedCensus joined;
  std::vector<Index> numbers(all.Components.size(), None); // of roots
  std::vector<Vector3> high;
  Index next = 0;
  for (const CensusOfPart& part : parts)
  {
    joined.OfComponent.emplace_back();
    for (std::size_t i = 0; i < part.All.size(); ++i, ++next)
    {
      Index& number = numbers[forest.Root(next)];
      if (number == None)
      {
        number = static_cast<Index>(joined.All.size());
        joined.All.emplace_back().Center = Vector3::Constant(Infinity);
        high.emplace_back(Vector3::Constant(-Infinity));
      }
      Add(all.Components[next], joined.All[number], high[number]);
      joined.OfComponent.back().push_back(number);
    }
  }
  for (std::size_t i = 0; i < joined.All.size(); ++i)
  {
    PrunedComponent& component = joined.All[i];
    component.Volume = std::abs(component.Volume);
    component.Size = (high[i] - component.Center).maxCoeff();
    component.Center = 0.5 * (component.Center + high[i]) + origin;
  }
  return joined;
}

//------------------------------------------------------------------------------
std::vector<double> NumbersOf(const CensusOfPart& part)
{
  std::vector<double> numbers = { static_cast<double>(part.All.size()),
    static_cast<double>(part.Points.size()) };
  for (const CensusOfPart::Component& component : part.All)
  {
    numbers.insert(numbers.end(),
      { static_cast<double>(component.Triangles), component.Area, component.Volume,
        component.IsOpen ? 1.0 : 0.0 });
    numbers.insert(numbers.end(), component.Box.begin(), component.Box.end());
  }
  for (const std::array<Index, 2>& point : part.Points)
  {
    numbers.insert(numbers.end(), point.begin(), point.end());
  }
  for (const std::array<Index, 3>& edge : part.Edges)
  {
    numbers.insert(numbers.end(), edge.begin(), edge.end());
  }
  return numbers;
}

//------------------------------------------------------------------------------
CensusOfPart CensusFrom(const std::vector<double>& numbers)
{
  CensusOfPart part;
  auto next = numbers.begin();
  const auto index = [&next] { return static_cast<Index>(*next++); };
  const Index components = index();
  const Index points = index();
  for (Index i = 0; i < components; ++i)
  {
    CensusOfPart::Component& component = part.All.emplace_back();
    component.Triangles = static_cast<std::int64_t>(*next++);
    component.Area = *next++;
    component.Volume = *next++;
    component.IsOpen = *next++ != 0.0;
    std::copy(next, next + 6, component.Box.begin());
    next += 6;
  }
  for (Index i = 0; i < points; ++i)
  {
    const Index position = index();
    part.Points.push_back({ position, index() });
  }
  while (next != numbers.end())
  {
    const Index from = index();
    const Index to = index();
    part.Edges.push_back({ from, to, index() });
  }
  return part;
}
}
