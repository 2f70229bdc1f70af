// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfEdgeMesh.h
 * @brief A triangle mesh as half-edges in flat arrays, with whatever is not manifold locked.
 *
 * Half-edge h = 4 f + k, k = 0, 1, 2, runs from corner k of face f to the next corner, the face on its left:
 *
 *              apex
 *             /    \            Next(h), Previous(h): the other two of the face
 *        Prev/      \Next       Twin(h): the other half of the edge, None on a border
 *           /   f    \          Outgoing(v): the half-edge from which the ring of v is walked
 *     Origin ---h---> Target      counter-clockwise; on a border vertex the one without a twin
 *
 * Invariants (checked by Invariants.h): twins point at each other and run opposite ways; a face is alive or its
 * corners are None; the ring of a vertex that is not locked is one fan that holds all its faces; locked vertices
 * never move, never vanish, and their rings are not walked. Frozen ones are like locked ones whose rings are in order;
 * pinned ones stay, but their faces may change: what is collapsed at them ends in them.
 *
 * A face is half a cache line, a vertex is one: an edge is judged from the two records of its ends.
 */
#ifndef BoneDecimate_Core_Mesh_HalfEdgeMesh_h
#define BoneDecimate_Core_Mesh_HalfEdgeMesh_h

#include "EdgeMatching.h"
#include "Memory/LargeArray.h"
#include "Surface.h"

#include <array>

namespace bonedecimate
{
enum class VertexKind : std::uint8_t
{
  Inside,       ///< Its faces close around it.
  Border,       ///< On an open border, its faces are one fan.
  Pinned,       ///< Its faces close around it, but other sheets meet there: it stays.
  PinnedBorder, ///< On the border of a sheet where others meet it, its faces are one fan: it stays.
  Locked,       ///< On a non-manifold edge, or where fans meet in one point, and not split.
  Frozen        ///< Asked to stay, or a corner of a face that was; its ring can be walked.
};

struct Neighbourhood;

/// How a surface was split, see Sheets.h.
struct SheetMap
{
  std::vector<Index>
    Sites;          ///< Of each point: the one that all its copies name. Empty: nothing was split.
  EdgeCounts Edges; ///< Before.
};

/// Sums over the triangles at a vertex, of area A and unit normal n: all planes pass through the vertex.
struct RingQuadric
{
  std::array<float, 6>
    M; ///< xx xy xz yy yz zz of the sum of 2 A n n^T, squares of the mesh's unit.
  std::array<float, 3> G; ///< Sum of 2 A n, squares of the mesh's unit.
};

struct alignas(64) VertexRecord
{
  Vector3 Position;    ///< mm from the local origin
  RingQuadric Quadric; ///< Kept by whoever needs it.
  Index Outgoing;
};
static_assert(sizeof(VertexRecord) == 64, "one cache line");

struct alignas(32) FaceRecord
{
  std::array<Index, 4> Origins; ///< The fourth: FirstNormal, x and y.
  std::array<Index, 4> Twins;   ///< The fourth: z, None: not kept yet.
};
static_assert(sizeof(FaceRecord) == 32, "half a cache line");

class HalfEdgeMesh
{
public:
  /// Every point must be used by a triangle, corners of a triangle must differ.
  /// @param labels Of each triangle: edges between different ones are locked, for Sheets.h to split. Empty: there are none.
  explicit HalfEdgeMesh(const Surface& surface, int threads = 1, const SheetMap& sheets = {},
    const std::vector<Index>& labels = {});

  // From the bits of the corner, since nobody can guess which corner it is: branches would be taken wrongly.
  static Index Next(Index h) { return h + 1 - 3 * (h >> 1 & 1); }
  static Index Previous(Index h) { return h + 2 - 3 * ((h | h >> 1) & 1); }
  static Index Face(Index h) { return h >> 2; }
  static Index HalfEdge(Index face, Index corner) { return 4 * face + corner; }

  Index Origin(Index h) const { return this->Faces[h >> 2].Origins[h & 3]; }
  Index Target(Index h) const { return this->Origin(Next(h)); }
  Index Twin(Index h) const { return this->Faces[h >> 2].Twins[h & 3]; }
  Index Outgoing(Index v) const { return this->Vertices[v].Outgoing; }
  VertexKind Kind(Index v) const { return this->Kinds[v]; }
  /// Locked or frozen: it never moves and never vanishes. Nothing changes a face of three such corners.
  bool IsFixed(Index v) const { return this->Kinds[v] >= VertexKind::Locked; }
  /// It never moves and never vanishes, but may be collapsed onto.
  bool IsPinned(Index v) const
  {
    return this->Kinds[v] == VertexKind::Pinned || this->Kinds[v] == VertexKind::PinnedBorder;
  }
  /// Its ring is open. Not to be asked of locked and frozen ones.
  bool IsOnBorder(Index v) const
  {
    return this->Kinds[v] == VertexKind::Border || this->Kinds[v] == VertexKind::PinnedBorder;
  }
  const Vector3& Position(Index v) const { return this->Vertices[v].Position; }
  const VertexRecord& Record(Index v) const { return this->Vertices[v]; }
  RingQuadric& Quadric(Index v) { return this->Vertices[v].Quadric; }
  VertexRecord* Records() { return this->Vertices.data(); } ///< To change quadrics, nothing else.
  const FaceRecord* RecordOfFace(Index h) const { return &this->Faces[Face(h)]; }
  bool IsAlive(Index face) const { return this->Faces[face].Origins[0] != None; }
  Triangle Corners(Index face) const
  {
    const std::array<Index, 4>& corners = this->Faces[face].Origins;
    return { corners[0], corners[1], corners[2] };
  }

  /**
   * Whether a face of that area vector would look away from where it looked before its first change. False if it has not
   * been changed yet: then nothing is known but what it is now.
   */
  bool IsTurnedOver(Index face, const Vector3& area) const
  {
    return this->Faces[face].Twins[3] != None && area.dot(this->FirstNormal(face)) < 0.0;
  }

  bool HasSheets() const { return !this->Sites.empty(); }
  /// The same for all copies of a point in the sheets that meet there; v where there is one only.
  Index Site(Index v) const { return this->Sites.empty() ? v : this->Sites[v]; }
  /// Copy after copy, and back to the first.
  Index NextCopy(Index v) const { return this->NextCopies.empty() ? v : this->NextCopies[v]; }

  Index NumberOfVertexSlots() const { return static_cast<Index>(this->Vertices.size()); }
  Index NumberOfFaceSlots() const { return static_cast<Index>(this->Faces.size()); }
  Index NumberOfFaces() const { return this->LiveFaces; }

  /// Mean length of the edges it was made with, one of each triangle, mm; 1 if there is no length.
  double LengthAtFirst() const { return this->Length; }
  /// Sheets counted as joined.
  const EdgeCounts& EdgesAtFirst() const { return this->Counts; }
  /// The power of two nearest below that length, mm.
  double Unit() const { return this->LengthUnit; }

  /// The half-edges that leave v, counter-clockwise, one for each of its faces. v must not be locked.
  class OutgoingRange;
  OutgoingRange OutgoingOf(Index v) const;

  /// Calls visit(h) for a half-edge of every edge at v, in ring order: outgoing ones, and on a border the last, incoming.
  template <typename Visit>
  void VisitEdges(Index v, Visit visit) const
  {
    this->VisitNeighbours(v, [&](Index h, Index) { visit(h); });
  }
  /// The same as visit(h, other end).
  template <typename Visit>
  void VisitNeighbours(Index v, Visit visit) const;

  /// The other end of the edge of half-edge h at v.
  Index Across(Index h, Index v) const
  {
    return this->Origin(h) == v ? this->Target(h) : this->Origin(h);
  }

private:
  friend class Editor; // the one choke point: nobody else changes a mesh

  void LinkCopies(const SheetMap& sheets);

  /// Merges the ends of the edge into `keep` (one of them) at `position`. The caller has judged that this is allowed.
  void Collapse(const Neighbourhood& around, Index keep, const Vector3& position);
  /// Turns the edge of h, which has two faces, into that between their apexes. The caller has judged as above.
  void Flip(Index h);
  /// Before the first edit.
  void Freeze(Index v)
  {
    this->Kinds[v] = this->Kinds[v] == VertexKind::Locked ? VertexKind::Locked : VertexKind::Frozen;
  }
  void Move(Index v, const Vector3& position) { this->Vertices[v].Position = position; }
  /// Before the face changes: keeps its normal if that is the first time.  @param area A vector along it.
  void KeepFirstNormal(Index face, const Vector3& area)
  {
    if (this->Faces[face].Twins[3] == None)
    {
      PackFirstNormal(this->Faces[face], area);
    }
  }
  static void PackFirstNormal(FaceRecord& record, const Vector3& area);
  /// Three numbers of 16 bits, the largest 32767: within a hundredth of a degree.
  Vector3 FirstNormal(Index face) const
  {
    const std::int32_t xy = this->Faces[face].Origins[3];
    const std::int32_t z = this->Faces[face].Twins[3];
    return { static_cast<double>(static_cast<std::int16_t>(xy >> 16)),
      static_cast<double>(static_cast<std::int16_t>(xy & 0xFFFF)),
      static_cast<double>(static_cast<std::int16_t>(z)) };
  }
  void Pair(Index h, Index twin);
  void RemoveFace(Index h);
  /// Several workers remove faces at once; the count follows when they are done.
  void CountRemovedFaces(Index count) { this->LiveFaces -= count; }

  LargeArray<VertexRecord> Vertices;
  LargeArray<FaceRecord> Faces;
  LargeArray<VertexKind> Kinds;
  std::vector<Index> Sites;      // of each vertex; empty: there is one sheet
  std::vector<Index> NextCopies; // of each vertex, if there are more
  Index LiveFaces = 0;
  EdgeCounts Counts;
  double Length = 1.0;     // mm
  double LengthUnit = 1.0; // mm
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
  Index Count() const
  {
    Index count = 0;
    for (Iterator h = this->begin(); h != this->end(); ++h)
    {
      ++count;
    }
    return count;
  }

private:
  const HalfEdgeMesh* Mesh;
  Index Start;
};

inline HalfEdgeMesh::OutgoingRange HalfEdgeMesh::OutgoingOf(Index v) const
{
  return { this, this->Outgoing(v) };
}

template <typename Visit>
void HalfEdgeMesh::VisitNeighbours(Index v, Visit visit) const
{
  Index last = None;
  for (const Index h : this->OutgoingOf(v))
  {
    visit(h, this->Target(h));
    last = Previous(h);
  }
  if (last != None && this->Twin(last) == None)
  {
    visit(last, this->Origin(last));
  }
}
}

#endif
