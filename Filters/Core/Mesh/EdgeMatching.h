// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeMatching.h
 * @brief Pairs the half-edges of a triangle list and classifies those without a twin.
 *
 * Half-edge 4 f + k runs from corner k of triangle f to the next corner; 4 f + 3 does not exist.
 *
 *     sort the half-edges by origin:    counting sort, about six at each point
 *     for each point, match its edges:  each triangle has one outgoing and one incoming half-edge
 *         one of each to every neighbor:  all are twins; found in one step by marks
 *         otherwise, edge by edge:        one half-edge: boundary; one each way: twins; else odd
 *     for each point, walk from twin to twin: its triangles are one fan if all are visited
 *
 * Work is divided into blocks of points and of triangles. The result does not depend on the number
 * of threads.
 */
#ifndef BoneDecimate_Core_Mesh_EdgeMatching_h
#define BoneDecimate_Core_Mesh_EdgeMatching_h

#include "Base/LargeArray.h"
#include "Geometry/Surface.h"
#include "VertexConstraint.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// In place of a twin: the edge has three or more triangles, or two of inconsistent orientation.
constexpr Index OddEdge = -2;

struct EdgeCounts
{
  std::int64_t Edges = 0;
  std::int64_t Boundary = 0;        ///< Edges of exactly one triangle.
  std::int64_t NonManifold = 0;     ///< Edges of three or more triangles.
  std::int64_t PairedHalfEdges = 0; ///< Half-edges with a twin; fewer after CutBetween.

  EdgeCounts& operator+=(const EdgeCounts& other)
  {
    this->Edges += other.Edges;
    this->Boundary += other.Boundary;
    this->NonManifold += other.NonManifold;
    this->PairedHalfEdges += other.PairedHalfEdges;
    return *this;
  }
};

/// The triangles around each point.
struct Rings
{
  /// For each point, the half-edge at which its ring starts: the last one without a twin, else the
  /// first one. None if unused.
  LargeArray<Index> Outgoing;
  /// For each point, NonManifold if one of its edges is odd or its triangles are not one fan.
  LargeArray<VertexConstraint> Constraints;
};
/// In ascending order.
std::vector<Index> NonManifoldPoints(const Rings& rings);

class EdgeMatching
{
public:
  /// Corners must be valid. Keeps a reference to the triangles.
  EdgeMatching(const std::vector<Triangle>& triangles, std::size_t numberOfPoints, int threads = 1);
  EdgeMatching(std::vector<Triangle>&&, std::size_t, int = 1) = delete;

  /// Matches again after the triangles have changed.
  void Match(std::size_t numberOfPoints);

  /// For each half-edge, its twin; None on a boundary, OddEdge if the twin is ambiguous.
  const LargeArray<Index>& Twins() const { return this->TwinOf; }

  EdgeCounts CountEdges() const;

  /// The half-edges that leave the point, ascending.
  std::vector<Index> OutgoingAt(Index point) const;

  /// Makes edges between triangles of different labels odd.
  /// @param labels The label of each triangle. Empty: no labels.
  void CutBetween(const std::vector<Index>& labels);

  /// The corners of each triangle must differ.
  Rings FindRings() const;

private:
  /// The half-edges from one point to another.
  struct Bundle
  {
    Index Count = 0;
    Index HalfEdge = None; // any of them
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
  bool IsFirstOnEdge(Index origin, Index halfEdge) const;
  Index TargetOf(Index halfEdge) const;
  void FindRing(Index point, Rings& rings) const;

  const std::vector<Triangle>& Triangles;
  int Threads;
  LargeArray<Index> Start;  // for each point, the index of its first spoke; finally, the end
  LargeArray<Index> Spokes; // half-edges by origin; if there are many at a point, also by target
  LargeArray<Index> TwinOf;
};
}

#endif
