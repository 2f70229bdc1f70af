// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneCover.h
 * @brief Proves by a walk that the original lies over every point of a face, nowhere farther than
 * the limit.
 *
 *     begin at an original triangle near the face, and cross every edge whose projection onto the
 *       face's plane meets the face
 *     an edge without a twin that meets the face:                          no
 *     over the face a triangle farther away than the limit:                no
 *     an odd number of projections over one point of the face:             yes
 *
 * No edge of the visited triangles ends their projection within the face, so the number of
 * projections over a point changes only by even numbers: if it is odd at one point, it is zero
 * nowhere.
 *
 * A projection has coordinates (b, c) of A + b AB + c AC, computed once for each vertex. The
 * distance that is compared with the limit is the one from this computed point, so its rounding
 * does no harm.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_PlaneCover_h
#define BoneDecimate_Core_Proof_ErrorBound_PlaneCover_h

#include "Mesh/HalfEdgeMesh.h"
#include "SparseSet.h"

#include <array>
#include <cstdint>

namespace bonedecimate
{
class PlaneCover
{
public:
  explicit PlaneCover(const HalfEdgeMesh& original)
    : OriginalMesh(original)
    , Triangles(original.NumberOfFaceSlots())
    , Projections(original.NumberOfVertexSlots())
  {
  }

  /// @param seed An original triangle near the middle of the face.
  /// @param limit Limit of an original triangle, mm.
  template <typename Limit>
  bool Prove(const std::array<Vector3, 3>& face, Index seed, const Limit& limit)
  {
    if (!this->Begin(face))
    {
      return false;
    }
    this->Triangles.Insert({ seed });
    for (Index at = 0; at < this->Triangles.Size(); ++at)
    {
      const Index id = this->Triangles[at].Id;
      if (at == MaxTriangles || !this->Visit(id, limit(id)))
      {
        return false;
      }
    }
    return this->IsOdd;
  }

  /// After a failed proof, a point of the face that is likely to be too far away.
  Vector3 SuspectPosition() const
  {
    return this->A + this->SuspectB * this->AB + this->SuspectC * this->AC;
  }

private:
  static constexpr Index MaxTriangles = 4096;
  struct Projection
  {
    Index Id;
    std::uint8_t Beyond; // bits: certainly beyond a side of the face
    std::uint8_t Beside; // bits: on a side of the point where projections are counted
    double B, C;
    Vector3 Offset;       // mm, from the projection to the vertex
    double SquaredOffset; // mm^2
    double A() const { return 1.0 - this->B - this->C; }
  };
  struct Visited
  {
    Index Id;
  };
  using ProjectedTriangle = std::array<Projection, 3>;

  bool Begin(const std::array<Vector3, 3>& face);
  const Projection& ProjectionOf(VertexId vertex);
  bool Visit(Index triangle, double limit);
  bool Count(const ProjectedTriangle& projected);
  bool Cross(Index edge);
  bool IsNearOver(const ProjectedTriangle& projected, double limit);

  const HalfEdgeMesh& OriginalMesh;
  SparseSet<Visited> Triangles;
  SparseSet<Projection> Projections;
  Vector3 A, AB, AC;
  Vector3 AlongB, AlongC; // 1/mm: b = AlongB . (p - A)
  double SuspectB = 0.0, SuspectC = 0.0;
  bool IsOdd = false;
};
}

#endif
