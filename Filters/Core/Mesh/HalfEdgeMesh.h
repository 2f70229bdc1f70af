// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfEdgeMesh.h
 * @brief A triangle mesh as half-edges in flat arrays. Its vertices are constrained where it is not
 * manifold.
 *
 * Half-edge h = 4 f + k, k = 0, 1, 2, runs from corner k of face f to the next corner, the face on
 * its left:
 *
 *              Apex(h)
 *              /    \            Next(h), Previous(h): the other two half-edges of the face
 *        Prev/      \Next       Twin(h): the other half-edge of the edge; None on a boundary
 *           /   f    \          Outgoing(v): the half-edge at which the ring of v starts,
 *     Origin ---h---> Target      counter-clockwise; at a boundary vertex the one without a twin
 *
 * Invariants, checked by Invariants.h:
 *
 *     twins refer to each other and have opposite directions
 *     a face is alive, or its corners are None
 *     the ring of a vertex that is not NonManifold is one fan with all its faces
 *
 * VertexConstraint.h says what edits may do to a vertex. A face record is half a cache line and a
 * vertex record is one, because edges are evaluated from the records of their ends.
 *
 * `Initial` is the state before the first edit.
 */
#ifndef BoneDecimate_Core_Mesh_HalfEdgeMesh_h
#define BoneDecimate_Core_Mesh_HalfEdgeMesh_h

#include "Base/LargeArray.h"
#include "EdgeMatching.h"
#include "Geometry/Surface.h"
#include "Handles.h"
#include "VertexConstraint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace bonedecimate
{
struct Edit;
struct EdgeNeighborhood;

/// How a surface was split into manifold patches (ManifoldPatches.h).
struct PatchMap
{
  /// For each point, its original vertex, common to all its duplicates. Empty: nothing was split.
  std::vector<Index> OriginalVertices;
  EdgeCounts Edges; ///< Before the split.
};

/// Sums over the triangles at a vertex, with area A and unit normal n. All planes pass through the
/// vertex.
struct RingQuadric
{
  /// Sum of 2 A n n^T as xx xy xz yy yz zz, squares of the mesh's unit.
  std::array<float, 6> M;
  std::array<float, 3> G; ///< Sum of 2 A n, squares of the mesh's unit.
};

struct alignas(64) VertexRecord
{
  Vector3 Position;    ///< mm from the local origin
  RingQuadric Quadric; ///< Maintained by the modes that need it.
  Index Outgoing;
};
static_assert(sizeof(VertexRecord) == 64, "one cache line");

struct alignas(32) FaceRecord
{
  std::array<Index, 4> Origins; ///< The fourth packs x and y of the initial normal.
  /// The fourth packs the initial area and z of the initial normal; None: not stored yet.
  std::array<Index, 4> Twins;
};
static_assert(sizeof(FaceRecord) == 32, "half a cache line");

class HalfEdgeMesh
{
public:
  /// Every point must be used by a triangle, and the corners of each triangle must differ.
  explicit HalfEdgeMesh(const Surface& surface, int threads = 1, const PatchMap& patches = {});
  /// @param edges The edges of these triangles.  @param rings The rings of the edges.
  HalfEdgeMesh(const Surface& surface, const EdgeMatching& edges, Rings rings, int threads,
    const PatchMap& patches = {});

  // From the bits of the corner: branches would be mispredicted.
  static HalfEdgeId Next(HalfEdgeId h) { return h + 1 - 3 * (h >> 1 & 1); }
  static HalfEdgeId Previous(HalfEdgeId h) { return h + 2 - 3 * ((h | h >> 1) & 1); }
  static FaceId Face(HalfEdgeId h) { return h >> 2; }
  static HalfEdgeId HalfEdge(FaceId face, Index corner) { return 4 * face + corner; }

  VertexId Origin(HalfEdgeId h) const { return this->Faces[h >> 2].Origins[h & 3]; }
  VertexId Target(HalfEdgeId h) const { return this->Origin(Next(h)); }
  VertexId Apex(HalfEdgeId h) const { return this->Origin(Previous(h)); }
  HalfEdgeId Twin(HalfEdgeId h) const { return this->Faces[h >> 2].Twins[h & 3]; }
  HalfEdgeId Outgoing(VertexId v) const { return this->Vertices[v].Outgoing; }
  VertexConstraint Constraint(VertexId v) const { return this->Constraints[v]; }
  /// VertexConstraint.h says what these mean.
  bool IsConstrained(VertexId v) const { return bonedecimate::IsConstrained(this->Constraints[v]); }
  bool IsStationary(VertexId v) const { return bonedecimate::IsStationary(this->Constraints[v]); }
  bool IsOnBoundary(VertexId v) const { return bonedecimate::IsOnBoundary(this->Constraints[v]); }
  bool MovesFreely(VertexId v) const { return bonedecimate::MovesFreely(this->Constraints[v]); }
  const Vector3& Position(VertexId v) const { return this->Vertices[v].Position; }
  const VertexRecord& Record(VertexId v) const { return this->Vertices[v]; }
  RingQuadric& Quadric(VertexId v) { return this->Vertices[v].Quadric; }
  VertexRecord* Records() { return this->Vertices.data(); } ///< For changes of quadrics only.
  const FaceRecord* RecordOfFace(HalfEdgeId h) const { return &this->Faces[Face(h)]; }
  bool IsAlive(FaceId face) const { return this->Faces[face].Origins[0] != None; }
  Triangle Corners(FaceId face) const
  {
    const std::array<Index, 4>& corners = this->Faces[face].Origins;
    return { corners[0], corners[1], corners[2] };
  }

  /// A face of more than this many times its initial area replaces so many faces that its initial
  /// normal says nothing about them.
  static constexpr double MaxAreaGrowth = 8.0;

  /**
   * Whether a face with that area vector would point away from its initial normal. False if the
   * face was never changed, or if its area exceeds MaxAreaGrowth times the initial one.
   * @param area Area vector, mm^2.
   */
  bool IsTurnedOver(FaceId face, const Vector3& area) const
  {
    return this->Faces[face].Twins[3] != None && Dot(area, this->InitialNormal(face)) < 0.0 &&
      !(area.norm() > MaxAreaGrowth * this->InitialArea(face));
  }

  /// Whether the face has been changed, so that its initial normal is stored.
  bool HasInitialNormal(FaceId face) const { return this->Faces[face].Twins[3] != None; }

  /// The input triangle whose labels the face has: the face itself, unless a split made it.
  FaceId InputFace(FaceId face) const
  {
    return this->InputFaces.empty() ? face
                                    : FaceId(this->InputFaces[static_cast<std::size_t>(face)]);
  }

  bool HasPatches() const { return !this->OriginalVertices.empty(); }
  /// The original vertex of all duplicates of a point; v if the point was not split.
  VertexId OriginalVertex(VertexId v) const
  {
    return this->OriginalVertices.empty() ? v : VertexId(this->OriginalVertices[v]);
  }
  /// The next duplicate, in a cyclic list of all duplicates of a point.
  VertexId NextDuplicate(VertexId v) const
  {
    return this->NextDuplicates.empty() ? v : VertexId(this->NextDuplicates[v]);
  }

  Index NumberOfVertexSlots() const { return static_cast<Index>(this->Vertices.size()); }
  Index NumberOfFaceSlots() const { return static_cast<Index>(this->Faces.size()); }
  Index NumberOfFaces() const { return this->LiveFaces; }

  /// Mean length of the first edges of all initial faces, mm; 1 if that is 0.
  double InitialEdgeLength() const { return this->Length; }
  /// Edge counts of the surface before its split into patches.
  const EdgeCounts& InitialEdgeCounts() const { return this->Counts; }
  /// The largest power of two that does not exceed the mean edge length, mm.
  double Unit() const { return this->LengthUnit; }

  /// The half-edges that leave v, counter-clockwise, one per face. v must not be NonManifold.
  class OutgoingRange;
  OutgoingRange OutgoingOf(VertexId v) const;

  /// Calls visit(h) once for every edge at v, in the order of the ring: for outgoing half-edges
  /// and, at a boundary, finally for an incoming one.
  template <typename Visit>
  void VisitEdges(VertexId v, Visit visit) const
  {
    this->VisitNeighbors(v, [&](HalfEdgeId h, Index) { visit(h); });
  }
  /// The same with visit(h, other end). visit may return a bool: false ends the visits.
  template <typename Visit>
  void VisitNeighbors(VertexId v, Visit visit) const;

  /// The end of the edge that is not v.
  VertexId OtherEnd(HalfEdgeId h, VertexId v) const
  {
    return this->Origin(h) == v ? this->Target(h) : this->Origin(h);
  }

private:
  friend class Editor; // the single mutation point

  void LinkDuplicates(const PatchMap& patches);

  /// Merges the ends of the edge into `keep`, one of them, at `position`. The caller has checked
  /// that this is valid.
  void Collapse(const EdgeNeighborhood& around, VertexId keep, const Vector3& position);
  /// Replaces the edge of h, which has two faces, by the edge between their apexes. The caller has
  /// checked that this is valid.
  void Flip(HalfEdgeId h);
  /// Puts the vertex edit.Keep, which has no faces, on the edge. Each face a b c at it keeps its id
  /// as a m c; its other half m b c gets an id from edit.Made. The caller has checked that this is
  /// valid.
  void Split(const Edit& edit);
  /// @param h From a to b, of the face a b c.  @param vertex m.  @param made Becomes m b c.
  void SplitFace(HalfEdgeId h, VertexId vertex, FaceId made);
  /// Only before the first edit.
  void Constrain(VertexId v)
  {
    this->Constraints[v] = this->Constraints[v] == VertexConstraint::NonManifold
      ? VertexConstraint::NonManifold
      : VertexConstraint::Constrained;
  }
  void Move(VertexId v, const Vector3& position) { this->Vertices[v].Position = position; }
  /// Stores normal and area of the face the first time. Must be called before the face changes.
  /// @param area Area vector, mm^2.
  void StoreInitialNormal(FaceId face, const Vector3& area)
  {
    if (this->Faces[face].Twins[3] == None)
    {
      PackInitialNormal(this->Faces[face], area);
    }
  }
  static void PackInitialNormal(FaceRecord& record, const Vector3& area);
  /// The normal is packed into three numbers of 16 bits, precise to 0.01 degrees, and the area into
  /// 16 bits, precise to 1 %.
  Vector3 InitialNormal(FaceId face) const
  {
    const std::int32_t xy = this->Faces[face].Origins[3];
    const std::int32_t z = this->Faces[face].Twins[3];
    return { static_cast<double>(static_cast<std::int16_t>(xy >> 16)),
      static_cast<double>(static_cast<std::int16_t>(xy & 0xFFFF)),
      static_cast<double>(static_cast<std::int16_t>(z)) };
  }
  /// The area before the first edit, mm^2.
  double InitialArea(FaceId face) const;
  /// Records that edits of faces change, to undo them: the faces, those beside them, and their
  /// corners.
  struct Saved
  {
    std::vector<std::pair<FaceId, FaceRecord>> Faces;
    std::vector<std::pair<VertexId, VertexRecord>> Vertices;
  };
  void Save(FaceId face, Saved& saved) const;
  void Restore(const Saved& saved);
  /// These undo a collapse: first the corners of each of its faces, then the twins of the removed
  /// ones. A removed face keeps its initial normal.
  void RestoreCorners(FaceId face, const Triangle& corners)
  {
    std::copy(corners.begin(), corners.end(), this->Faces[face].Origins.begin());
  }
  void RestoreTwins(FaceId face, const std::array<Index, 3>& twins)
  {
    for (Index k = 0; k < 3; ++k)
    {
      this->Pair(HalfEdge(face, k), twins[static_cast<std::size_t>(k)]);
    }
  }
  /// Makes the face one that was never changed.
  void ForgetInitialNormal(FaceId face)
  {
    this->Faces[face].Origins[3] = None;
    this->Faces[face].Twins[3] = None;
  }
  /// Has no effect if another edit has removed that half-edge.
  void RestoreOutgoing(VertexId v, HalfEdgeId h)
  {
    this->Vertices[v].Outgoing = this->Origin(h) == v ? h : this->Outgoing(v);
  }
  void Pair(HalfEdgeId h, HalfEdgeId twin);
  void RemoveFace(HalfEdgeId h);
  /// Updates the number of faces after parallel workers have removed some.
  void CountRemovedFaces(Index count) { this->LiveFaces -= count; }

  LargeArray<VertexRecord> Vertices;
  LargeArray<FaceRecord> Faces;
  LargeArray<VertexConstraint> Constraints;
  std::vector<Index> OriginalVertices; // for each vertex; empty: nothing was split
  std::vector<Index> NextDuplicates;   // for each vertex, if there are duplicates
  std::vector<Index> InputFaces;       // for each face; empty: no edge was split
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
    Iterator(const HalfEdgeMesh* mesh, HalfEdgeId start, HalfEdgeId at)
      : Mesh(mesh)
      , Start(start)
      , At(at)
    {
    }
    HalfEdgeId operator*() const { return this->At; }
    bool operator!=(const Iterator& other) const { return this->At != other.At; }
    Iterator& operator++()
    {
      const HalfEdgeId next = this->Mesh->Twin(Previous(this->At));
      this->At = next == this->Start ? HalfEdgeId() : next;
      return *this;
    }

  private:
    const HalfEdgeMesh* Mesh;
    HalfEdgeId Start;
    HalfEdgeId At;
  };
  OutgoingRange(const HalfEdgeMesh* mesh, HalfEdgeId start)
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
  HalfEdgeId Start;
};

inline HalfEdgeMesh::OutgoingRange HalfEdgeMesh::OutgoingOf(VertexId v) const
{
  return { this, this->Outgoing(v) };
}

template <typename Visit>
void HalfEdgeMesh::VisitNeighbors(VertexId v, Visit visit) const
{
  HalfEdgeId last;
  for (const HalfEdgeId h : this->OutgoingOf(v))
  {
    if constexpr (std::is_same_v<decltype(visit(h, this->Target(h))), bool>)
    {
      if (!visit(h, this->Target(h)))
      {
        return;
      }
    }
    else
    {
      visit(h, this->Target(h));
    }
    last = Previous(h);
  }
  if (last != None && this->Twin(last) == None)
  {
    visit(last, this->Origin(last));
  }
}

/// Corners of a face, mm.
inline std::array<Vector3, 3> PositionsOf(const HalfEdgeMesh& mesh, FaceId face)
{
  const Triangle c = mesh.Corners(face);
  return { mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]) };
}
}

#endif
