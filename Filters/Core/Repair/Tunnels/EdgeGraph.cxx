// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeGraph.h"

#include "Mesh/HalfEdgeMesh.h"

#include <algorithm>
#include <functional>

namespace bonedecimate
{
namespace
{
/// The finalizer of the generator splitmix64: well distributed words from consecutive numbers.
std::uint64_t WordOfEdge(std::size_t edge)
{
  std::uint64_t word = (static_cast<std::uint64_t>(edge) + 1) * 0x9E3779B97F4A7C15ULL;
  word = (word ^ (word >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  word = (word ^ (word >> 27U)) * 0x94D049BB133111EBULL;
  return word ^ (word >> 31U);
}

/// A list of numbers for each of a range of ids, one after the other.
struct Lists
{
  std::vector<Index> Start;
  std::vector<Index> Items;
};

/// The edges of each face and boundary.
Lists EdgesOfSides(const std::vector<GraphEdge>& edges, std::size_t sides)
{
  Lists lists;
  lists.Start.assign(sides + 1, 0);
  for (const GraphEdge& edge : edges)
  {
    for (const Index side : edge.Sides)
    {
      ++lists.Start[static_cast<std::size_t>(side) + 1];
    }
  }
  for (std::size_t side = 0; side < sides; ++side)
  {
    lists.Start[side + 1] += lists.Start[side];
  }
  std::vector<Index> next(lists.Start.begin(), lists.Start.end() - 1);
  lists.Items.resize(2 * edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    for (const Index side : edges[e].Sides)
    {
      lists.Items[static_cast<std::size_t>(next[static_cast<std::size_t>(side)]++)] =
        static_cast<Index>(e);
    }
  }
  return lists;
}
}

EdgeGraph::EdgeGraph(const Surface& surface, int threads)
  : Triangles(surface.Triangles)
  , Matching(surface.Triangles, surface.Points.size(), threads)
  , PointRings(Matching.FindRings())
{
  this->NumberBoundaries();
  this->MakeEdges(surface);
  this->MakeSpokes(surface.Points.size());
  const std::vector<bool> isInTree = this->GrowTrees(surface.Points.size());
  this->SetSignatures(isInTree, this->GrowCotrees(isInTree));
}

//------------------------------------------------------------------------------
void EdgeGraph::NumberBoundaries()
{
  const auto count = static_cast<Index>(this->Triangles.size());
  this->BoundaryOf.assign(4 * this->Triangles.size(), None);
  for (Index h = 0; h < 4 * count; ++h)
  {
    if ((h & 3) == 3 || this->Twin(h) >= 0 || this->BoundaryOf[static_cast<std::size_t>(h)] != None)
    {
      continue;
    }
    for (Index at = h; this->BoundaryOf[static_cast<std::size_t>(at)] == None;)
    {
      this->BoundaryOf[static_cast<std::size_t>(at)] = this->NumberOfBoundaries;
      at = HalfEdgeMesh::Next(at);
      while (this->Twin(at) >= 0)
      {
        at = HalfEdgeMesh::Next(this->Twin(at));
      }
    }
    ++this->NumberOfBoundaries;
  }
}

//------------------------------------------------------------------------------
void EdgeGraph::MakeEdges(const Surface& surface)
{
  const auto count = static_cast<Index>(this->Triangles.size());
  this->EdgeList.reserve(3 * this->Triangles.size() / 2);
  for (Index h = 0; h < 4 * count; ++h)
  {
    const Index twin = (h & 3) == 3 ? h : this->Twin(h);
    if ((h & 3) == 3 || (twin >= 0 && twin < h))
    {
      continue;
    }
    const Triangle& corners = this->Triangles[static_cast<std::size_t>(h >> 2)];
    const Index from = corners[static_cast<std::size_t>(h & 3)];
    const Index to = corners[static_cast<std::size_t>(HalfEdgeMesh::Next(h) & 3)];
    const Index other =
      twin >= 0 ? twin >> 2 : count + this->BoundaryOf[static_cast<std::size_t>(h)];
    const double length = (surface.Points[static_cast<std::size_t>(from)] -
      surface.Points[static_cast<std::size_t>(to)])
                            .norm();
    this->EdgeList.push_back({ { from, to }, { h >> 2, other }, length });
  }
}

//------------------------------------------------------------------------------
void EdgeGraph::MakeSpokes(std::size_t points)
{
  this->Start.assign(points + 2, 0);
  for (const GraphEdge& edge : this->EdgeList)
  {
    ++this->Start[static_cast<std::size_t>(edge.Ends[0]) + 1];
    ++this->Start[static_cast<std::size_t>(edge.Ends[1]) + 1];
  }
  for (std::size_t p = 0; p <= points; ++p)
  {
    this->Start[p + 1] += this->Start[p];
  }
  std::vector<Index> next(this->Start.begin(), this->Start.end() - 1);
  this->Spokes.resize(2 * this->EdgeList.size());
  for (std::size_t e = 0; e < this->EdgeList.size(); ++e)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      const Index from = this->EdgeList[e].Ends[end];
      const Index slot = next[static_cast<std::size_t>(from)]++;
      this->Spokes[static_cast<std::size_t>(slot)] = { this->EdgeList[e].Ends[1 - end],
        static_cast<Index>(e) };
    }
  }
}

//------------------------------------------------------------------------------
/// Counts the components.  @return For each edge whether it is in the tree.
std::vector<bool> EdgeGraph::GrowTrees(std::size_t points)
{
  std::vector<bool> isInTree(this->EdgeList.size(), false);
  std::vector<bool> isReached(points, false);
  std::vector<Index> queue;
  queue.reserve(points);
  for (std::size_t root = 0; root < points; ++root)
  {
    if (isReached[root] || this->Outgoing(static_cast<Index>(root)) == None)
    {
      continue;
    }
    ++this->NumberOfComponents;
    isReached[root] = true;
    queue.assign(1, static_cast<Index>(root));
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const Index from = queue[i];
      for (const GraphSpoke* spoke = this->Begin(from); spoke != this->End(from); ++spoke)
      {
        if (!isReached[static_cast<std::size_t>(spoke->To)])
        {
          isReached[static_cast<std::size_t>(spoke->To)] = true;
          isInTree[static_cast<std::size_t>(spoke->Edge)] = true;
          queue.push_back(spoke->To);
        }
      }
    }
  }
  return isInTree;
}

//------------------------------------------------------------------------------
EdgeGraph::Cotrees EdgeGraph::GrowCotrees(const std::vector<bool>& isInTree) const
{
  const std::size_t sides =
    this->Triangles.size() + static_cast<std::size_t>(this->NumberOfBoundaries);
  const Lists around = EdgesOfSides(this->EdgeList, sides);
  Cotrees trees;
  trees.EdgeToParent.assign(sides, None);
  trees.Order.reserve(sides);
  std::vector<bool> isReached(sides, false);
  for (std::size_t root = 0; root < sides; ++root)
  {
    if (isReached[root])
    {
      continue;
    }
    isReached[root] = true;
    trees.Order.push_back(static_cast<Index>(root));
    for (std::size_t i = trees.Order.size() - 1; i < trees.Order.size(); ++i)
    {
      const Index side = trees.Order[i];
      const auto at = static_cast<std::size_t>(side);
      for (Index k = around.Start[at]; k < around.Start[at + 1]; ++k)
      {
        const Index e = around.Items[static_cast<std::size_t>(k)];
        const std::array<Index, 2>& ends = this->EdgeList[static_cast<std::size_t>(e)].Sides;
        const auto other = static_cast<std::size_t>(ends[0] == side ? ends[1] : ends[0]);
        if (!isInTree[static_cast<std::size_t>(e)] && !isReached[other])
        {
          isReached[other] = true;
          trees.EdgeToParent[other] = e;
          trees.Order.push_back(static_cast<Index>(other));
        }
      }
    }
  }
  return trees;
}

//------------------------------------------------------------------------------
/// Signatures of edges of the cotrees are sums from the leaves to the roots.
void EdgeGraph::SetSignatures(const std::vector<bool>& isInTree, const Cotrees& trees)
{
  std::vector<bool> isLeftover(this->EdgeList.size());
  std::transform(isInTree.begin(), isInTree.end(), isLeftover.begin(), std::logical_not<>());
  for (const Index e : trees.EdgeToParent)
  {
    if (e != None)
    {
      isLeftover[static_cast<std::size_t>(e)] = false;
    }
  }
  std::vector<std::uint64_t> below(
    trees.Order.size(), 0); // sum of the words that leave the subtree of a face
  for (std::size_t e = 0; e < this->EdgeList.size(); ++e)
  {
    if (isLeftover[e])
    {
      GraphEdge& edge = this->EdgeList[e];
      edge.Signature = WordOfEdge(e);
      below[static_cast<std::size_t>(edge.Sides[0])] ^= edge.Signature;
      below[static_cast<std::size_t>(edge.Sides[1])] ^= edge.Signature;
      ++this->NumberOfLeftovers;
    }
  }
  for (std::size_t i = trees.Order.size(); i-- > 0;)
  {
    const Index side = trees.Order[i];
    const Index e = trees.EdgeToParent[static_cast<std::size_t>(side)];
    if (e != None)
    {
      GraphEdge& edge = this->EdgeList[static_cast<std::size_t>(e)];
      edge.Signature = below[static_cast<std::size_t>(side)];
      const Index parent = edge.Sides[0] == side ? edge.Sides[1] : edge.Sides[0];
      below[static_cast<std::size_t>(parent)] ^= edge.Signature;
    }
  }
}
}
