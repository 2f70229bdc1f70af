// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeMatching.h
 * @brief Which half-edges of a triangle list are the two halves of one edge, and what is odd about the others.
 *
 * Half-edge 4 f + k runs from corner k of triangle f to the next corner; 4 f + 3 does not exist.
 *
 *     sort the half-edges by their origin               counting sort, about six at each point
 *     for each point:                                   each of its triangles has a half-edge that leaves and one that
 *       to each neighbour one leaves, one arrives: twins  arrives; marks find the partner in one step
 *       if not, for each of its edges:                    one half-edge: border; one each way: twins; otherwise odd
 *     for each point: walk from twin to twin            all its triangles met: one fan
 *
 * Work is cut into blocks of points and of triangles; nothing depends on the number of threads.
 */
#ifndef BoneDecimate_Core_Mesh_EdgeMatching_h
#define BoneDecimate_Core_Mesh_EdgeMatching_h

#include "Memory/LargeArray.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate
{
enum class VertexKind : std::uint8_t; // HalfEdgeMesh.h

/// Instead of a twin: three or more triangles on the edge, or two that run along it in the same direction.
constexpr Index OddEdge = -2;

struct EdgeCounts
{
  std::int64_t Edges = 0;
  std::int64_t Border = 0;      ///< Of exactly one triangle.
  std::int64_t NonManifold = 0; ///< Of three or more triangles.
  std::int64_t HalfPairs = 0;   ///< Half-edges that have a twin.

  EdgeCounts& operator+=(const EdgeCounts& other)
  {
    this->Edges += other.Edges;
    this->Border += other.Border;
    this->NonManifold += other.NonManifold;
    this->HalfPairs += other.HalfPairs;
    return *this;
  }
};

/// The triangles around each point.
struct Rings
{
  /// Of each point the half-edge at which its ring starts: the greatest without a twin, else the least. None if unused.
  LargeArray<Index> Outgoing;
  /// Of each point: locked if one of its edges is odd or its triangles are not one fan.
  LargeArray<VertexKind> Kinds;
};

class EdgeMatching
{
public:
  /// Corners must be valid. Keeps a reference to the triangles.
  EdgeMatching(const std::vector<Triangle>& triangles, std::size_t numberOfPoints, int threads = 1);
  EdgeMatching(std::vector<Triangle>&&, std::size_t, int = 1) = delete;

  /// Of half-edge 4 f + k: its twin, None on a border, OddEdge where there is no telling.
  const LargeArray<Index>& Twins() const { return this->TwinOf; }

  EdgeCounts CountEdges() const;

  /// From now on there is no telling where triangles of different labels share an edge.  @param labels Of each triangle.
  void CutBetween(const std::vector<Index>& labels);

  /// Corners of a triangle must differ.
  Rings FindRings() const;

private:
  /// A half-edge as its origin sees it.
  struct Spoke
  {
    Index Target;
    Index HalfEdge;
  };
  /// The half-edges from one point to another.
  struct Bundle
  {
    Index Count = 0;
    Index HalfEdge = None; // one of them
  };

  void SortByOrigin();
  void SortLongLists(std::size_t firstPoint, std::size_t lastPoint);
  class Marks;
  void MatchBlock(std::size_t firstPoint, std::size_t lastPoint);
  bool MatchPairs(Index point, Marks& marks);
  void MatchOneByOne(Index point);
  Bundle Between(Index from, Index to) const;
  void CountEdgesOf(Index triangle, EdgeCounts& counts) const;
  Index CountOnEdge(Index a, Index b) const;
  bool IsFirstOnEdge(Index origin, const Spoke& spoke) const;
  void FindRing(Index point, Rings& rings) const;

  const std::vector<Triangle>& Triangles;
  int Threads;
  LargeArray<Index> Start;  // of each point its first spoke, and one behind the last
  LargeArray<Spoke> Spokes; // by origin; of many at one point by target
  LargeArray<Index> TwinOf;
};
}

#endif
