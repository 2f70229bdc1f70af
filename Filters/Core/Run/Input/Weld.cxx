// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace bonedecimate
{
namespace
{
using Edge = std::array<Index, 2>;

Edge EdgeOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

std::array<double, 3> KeyOf(const Vector3& point)
{
  return { point[0], point[1], point[2] };
}

/// Cells of a grid, each as wide as the distance, with the leaders in them.
class LeaderGrid
{
public:
  explicit LeaderGrid(double width)
    : Width(width)
  {
  }

  void Add(const Vector3& point, Index leader)
  {
    this->Cells[HashOf(CellOf(point))].push_back(leader);
  }

  /// Calls with every leader in the cells around a point, and with others now and then.
  template <typename Visit>
  void VisitNear(const Vector3& point, const Visit& visit) const
  {
    const std::array<double, 3> cell = this->CellOf(point);
    for (const double x : { -1.0, 0.0, 1.0 })
    {
      for (const double y : { -1.0, 0.0, 1.0 })
      {
        for (const double z : { -1.0, 0.0, 1.0 })
        {
          const auto found = this->Cells.find(HashOf({ cell[0] + x, cell[1] + y, cell[2] + z }));
          if (found != this->Cells.end())
          {
            std::for_each(found->second.begin(), found->second.end(), visit);
          }
        }
      }
    }
  }

private:
  std::array<double, 3> CellOf(const Vector3& point) const
  {
    return { std::floor(point[0] / this->Width), std::floor(point[1] / this->Width),
      std::floor(point[2] / this->Width) };
  }

  static std::size_t HashOf(const std::array<double, 3>& cell)
  {
    std::size_t hash = 0;
    for (const double number : cell)
    {
      hash = (hash ^ std::hash<double>()(number + 0.0)) * 0x9E3779B97F4A7C15U; // 0 for -0, too
      hash ^= hash >> 29;
    }
    return hash;
  }

  double Width; // mm
  std::unordered_map<std::size_t, std::vector<Index>> Cells;
};

class Welder
{
public:
  Welder(const Surface& input, double distance, const std::vector<char>& stays)
    : Input(input)
    , Distance(distance)
    , Grid(distance)
  {
    this->FindPositions();
    this->Stays.assign(this->Positions.size(), 0);
    for (std::size_t i = 0; i < stays.size(); ++i)
    {
      const Index position = this->PositionOf[i];
      this->Stays[position] = static_cast<char>(this->Stays[position] != 0 || stays[i] != 0);
    }
    this->FindEdges();
  }

  WeldedPoints Run()
  {
    this->ChooseLeaders();
    this->LeaveUnjoined();
    WeldedPoints welded;
    welded.Points = this->Input.Points;
    for (std::size_t i = 0; i < welded.Points.size(); ++i)
    {
      const Vector3& target = this->Positions[this->Leader[this->PositionOf[i]]];
      const double moved = (welded.Points[i] - target).norm();
      if (moved > 0.0)
      {
        ++welded.Moved;
        welded.Movement = std::max(welded.Movement, moved);
        welded.Points[i] = target;
      }
    }
    constexpr double slack = 1.0 + 1e-12; // of the length above
    welded.Movement *= slack;
    return welded;
  }

private:
  /// Points of equal coordinates have one position; positions are in the order of x, y and z.
  void FindPositions()
  {
    std::vector<char> isUsed(this->Input.Points.size(), 0);
    for (const Triangle& triangle : this->Input.Triangles)
    {
      for (const Index corner : triangle)
      {
        isUsed[corner] = 1;
      }
    }
    std::vector<Index> order(this->Input.Points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [this](Index point) { return KeyOf(this->Input.Points[point]); };
    order.erase(std::remove_if(order.begin(), order.end(),
                  [&isUsed](Index point) { return isUsed[point] == 0; }),
      order.end());
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    // Points that no triangle uses stay where they are.
    this->PositionOf.assign(this->Input.Points.size(), None);
    for (const Index point : order)
    {
      if (this->Positions.empty() || KeyOf(this->Positions.back()) != key(point))
      {
        this->Positions.push_back(this->Input.Points[point]);
      }
      this->PositionOf[point] = static_cast<Index>(this->Positions.size()) - 1;
    }
    for (std::size_t i = 0; i < this->PositionOf.size(); ++i)
    {
      if (this->PositionOf[i] == None)
      {
        this->PositionOf[i] = static_cast<Index>(this->Positions.size());
        this->Positions.push_back(this->Input.Points[i]);
      }
    }
  }

  void FindEdges()
  {
    std::vector<Edge> edges;
    for (const Triangle& triangle : this->Input.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index a = this->PositionOf[triangle[k]];
        const Index b = this->PositionOf[triangle[(k + 1) % 3]];
        if (a != b)
        {
          edges.push_back(EdgeOf(a, b));
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    this->NeighborStart.assign(this->Positions.size() + 1, 0);
    for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
    {
      next = first;
      while (next < edges.size() && edges[next] == edges[first])
      {
        ++next;
      }
      if (next - first == 1)
      {
        this->Boundary.push_back(edges[first]);
      }
      this->Edges.push_back(edges[first]);
      for (const Index end : edges[first])
      {
        ++this->NeighborStart[end + 1];
      }
    }
    std::partial_sum(
      this->NeighborStart.begin(), this->NeighborStart.end(), this->NeighborStart.begin());
    this->Neighbors.resize(2 * this->Edges.size());
    std::vector<std::size_t> at = this->NeighborStart;
    for (const Edge& edge : this->Edges)
    {
      this->Neighbors[at[edge[0]]++] = edge[1];
      this->Neighbors[at[edge[1]]++] = edge[0];
    }
  }

  void ChooseLeaders()
  {
    this->Leader.resize(this->Positions.size());
    std::iota(this->Leader.begin(), this->Leader.end(), 0);
    std::vector<char> isOnBoundary(this->Positions.size(), 0);
    for (const Edge& edge : this->Boundary)
    {
      isOnBoundary[edge[0]] = isOnBoundary[edge[1]] = 1;
    }
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      const auto position = static_cast<Index>(i);
      if (isOnBoundary[i] != 0 && this->Stays[i] == 0)
      {
        this->Leader[i] = this->NearestLeader(position);
        if (this->Leader[i] == position)
        {
          this->Grid.Add(this->Positions[i], position);
        }
      }
    }
  }

  /// The position itself if there is none.
  Index NearestLeader(Index position) const
  {
    std::vector<Index> ofNeighbors;
    for (std::size_t k = this->NeighborStart[position]; k < this->NeighborStart[position + 1]; ++k)
    {
      ofNeighbors.push_back(this->Leader[this->Neighbors[k]]);
    }
    std::sort(ofNeighbors.begin(), ofNeighbors.end());
    Index best = position;
    double nearest = std::numeric_limits<double>::infinity();
    this->Grid.VisitNear(this->Positions[position],
      [&](Index leader)
      {
        const double away = (this->Positions[position] - this->Positions[leader]).norm();
        const bool isNearer = away < nearest || (away == nearest && leader < best);
        if (away <= this->Distance && isNearer &&
          !std::binary_search(ofNeighbors.begin(), ofNeighbors.end(), leader))
        {
          nearest = away;
          best = leader;
        }
      });
    return best;
  }

  /// Positions whose move joins no edges stay where they are.
  void LeaveUnjoined()
  {
    std::vector<std::pair<Edge, Edge>> byLeaders; // of each boundary edge its leaders and its ends
    byLeaders.reserve(this->Boundary.size());
    for (const Edge& edge : this->Boundary)
    {
      byLeaders.emplace_back(EdgeOf(this->Leader[edge[0]], this->Leader[edge[1]]), edge);
    }
    std::sort(byLeaders.begin(), byLeaders.end());
    std::vector<char> isJoined(this->Positions.size(), 0);
    for (std::size_t first = 0, next = 0; first < byLeaders.size(); first = next)
    {
      next = first;
      while (next < byLeaders.size() && byLeaders[next].first == byLeaders[first].first)
      {
        ++next;
      }
      for (std::size_t i = first; next - first > 1 && i < next; ++i)
      {
        isJoined[byLeaders[i].second[0]] = isJoined[byLeaders[i].second[1]] = 1;
      }
    }
    for (std::size_t i = 0; i < this->Leader.size(); ++i)
    {
      this->Leader[i] = isJoined[i] != 0 ? this->Leader[i] : static_cast<Index>(i);
    }
  }

  const Surface& Input;
  double Distance; // mm
  LeaderGrid Grid;
  std::vector<Vector3> Positions;
  std::vector<Index> PositionOf; // of each point
  std::vector<char> Stays;       // of each position
  std::vector<Edge> Edges;       // between positions, each once
  std::vector<Edge> Boundary;    // those of one triangle
  std::vector<std::size_t> NeighborStart;
  std::vector<Index> Neighbors;
  std::vector<Index> Leader; // of each position
};
}

WeldedPoints Weld(const Surface& input, double distance, const std::vector<char>& stays)
{
  return Welder(input, distance, stays).Run();
}
}
