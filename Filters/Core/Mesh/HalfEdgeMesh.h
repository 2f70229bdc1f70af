// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfEdgeMesh.h
 * @brief A triangle mesh as half-edges in flat arrays, with whatever is not manifold locked.
 *
 * Half-edge h = 3 f + k runs from corner k of face f to the next corner, the face on its left:
 *
 *              apex
 *             /    \            Next(h), Previous(h): the other two of the face
 *        Prev/      \Next       Twin(h): the other half of the edge, None on a border
 *           /   f    \          Outgoing(v): the half-edge from which the ring of v is walked
 *     Origin ---h---> Target      counter-clockwise; on a border vertex the one without a twin
 *
 * Invariants (checked by Invariants.h): twins point at each other and run opposite ways; a face is alive or its
 * corners are None; the ring of a vertex that is not locked is one fan that holds all its faces; locked vertices
 * never move, never vanish, and their rings are not walked.
 */
#ifndef BoneDecimate_Core_Mesh_HalfEdgeMesh_h
#define BoneDecimate_Core_Mesh_HalfEdgeMesh_h

#include "Surface.h"

#include <vector>

namespace bonedecimate
{
enum class VertexKind : std::uint8_t
{
  Inside, ///< Its faces close around it.
  Border, ///< On an open border, its faces are one fan.
  Locked  ///< On a non-manifold edge, or where fans meet in one point.
};

class HalfEdgeMesh
{
public:
  /// Every point must be used by a triangle, corners of a triangle must differ.
  explicit HalfEdgeMesh(const Surface& surface);

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static Index Face(Index h) { return h / 3; }
  static Index HalfEdgeOf(Index face) { return 3 * face; } ///< That which leaves corner 0.

  Index Origin(Index h) const { return this->Origins[h]; }
  Index Target(Index h) const { return this->Origins[Next(h)]; }
  Index Twin(Index h) const { return this->Twins[h]; }
  Index Outgoing(Index v) const { return this->Outgoings[v]; }
  VertexKind Kind(Index v) const { return this->Kinds[v]; }
  const Vector3& Position(Index v) const { return this->Positions[v]; } // mm from the local origin
  bool IsAlive(Index face) const { return this->Origins[3 * face] != None; }
  Triangle Corners(Index face) const
  {
    return { this->Origins[3 * face], this->Origins[3 * face + 1], this->Origins[3 * face + 2] };
  }

  Index NumberOfVertexSlots() const { return static_cast<Index>(this->Positions.size()); }
  Index NumberOfFaceSlots() const { return static_cast<Index>(this->Origins.size() / 3); }
  Index NumberOfFaces() const { return this->LiveFaces; }

  /// The half-edges that leave v, counter-clockwise, one for each of its faces. v must not be locked.
  class OutgoingRange;
  OutgoingRange OutgoingOf(Index v) const;

  /// Calls visit(h) for a half-edge of every edge at v, in ring order: outgoing ones, and on a border the last, incoming.
  template <typename Visit>
  void VisitEdges(Index v, Visit visit) const;

  /// The other end of the edge of half-edge h at v.
  Index Across(Index h, Index v) const
  {
    return this->Origin(h) == v ? this->Target(h) : this->Origin(h);
  }

private:
  friend class Editor; // the one choke point: nobody else changes a mesh

  /// Merges the ends of h into `keep` (one of them) at `position`. The caller has judged that this is allowed.
  void Collapse(Index h, Index keep, const Vector3& position);
  /// Turns the edge of h, which has two faces, into that between their apexes. The caller has judged as above.
  void Flip(Index h);
  void Move(Index v, const Vector3& position) { this->Positions[v] = position; }
  void Pair(Index h, Index twin);
  void RemoveFace(Index h);
  Index LiveOutgoing(Index h) const;
  void TurnToBorder(Index v);
  void MatchEdges(const Surface& surface);
  void FindRings();

  std::vector<Vector3> Positions;
  std::vector<Index> Origins;
  std::vector<Index> Twins;
  std::vector<Index> Outgoings;
  std::vector<VertexKind> Kinds;
  Index LiveFaces = 0;
};

class HalfEdgeMesh::OutgoingRange
{
public:
  class Iterator
  {
  public:
    Iterator(const HalfEdgeMesh* mesh, Index start, Index at)
      : Mesh(mesh)
      , Start(start)
      , At(at)
    {
    }
    Index operator*() const { return this->At; }
    bool operator!=(const Iterator& other) const { return this->At != other.At; }
    Iterator& operator++()
    {
      const Index next = this->Mesh->Twin(Previous(this->At));
      this->At = next == this->Start ? None : next;
      return *this;
    }

  private:
    const HalfEdgeMesh* Mesh;
    Index Start;
    Index At;
  };
  OutgoingRange(const HalfEdgeMesh* mesh, Index start)
    : Mesh(mesh)
    , Start(start)
  {
  }
  Iterator begin() const { return { this->Mesh, this->Start, this->Start }; }
  Iterator end() const { return { this->Mesh, this->Start, None }; }

private:
  const HalfEdgeMesh* Mesh;
  Index Start;
};

inline HalfEdgeMesh::OutgoingRange HalfEdgeMesh::OutgoingOf(Index v) const
{
  return { this, this->Outgoings[v] };
}

template <typename Visit>
void HalfEdgeMesh::VisitEdges(Index v, Visit visit) const
{
  Index last = None;
  for (const Index h : this->OutgoingOf(v))
  {
    visit(h);
    last = Previous(h);
  }
  if (last != None && this->Twin(last) == None)
  {
    visit(last);
  }
}
}

#endif
