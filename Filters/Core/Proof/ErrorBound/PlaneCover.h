// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneCover.h
 * @brief Whether the original lies over every point of a face, never farther than the limit: proved
 * by a walk.
 *
 *     begin at an original triangle near the face, and cross every edge whose shadow on the face's
 *       plane meets the face
 *     an edge without a twin that meets the face:                          no
 *     over the face a triangle farther away than the limit:                no
 *     an odd number of shadows over one point of the face:                 yes
 *
 * Where no edge of what was walked over ends the shadow within the face, the number of shadows over
 * a point changes only by even numbers: odd at one point, it is nowhere zero. Shadows are
 * coordinates (b, c) of A + b AB + c AC, computed once for each vertex; how far they are from being
 * feet of perpendiculars is part of the distance that is compared with the limit, so that their
 * rounding does no harm.
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
    : Original(original)
    , Triangles(original.NumberOfFaceSlots())
    , Shadows(original.NumberOfVertexSlots())
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
  Vector3 Suspect() const
  {
    return this->A + this->SuspectB * this->AB + this->SuspectC * this->AC;
  }

private:
  static constexpr Index MaxTriangles = 4096;
  struct Shadow
  {
    Index Id;
    std::uint8_t Beyond; // bits: surely on the other side of a side of the face
    std::uint8_t Beside; // bits: on one side of the point where projections are counted
    double B, C;
    Vector3 Offset;       // mm, from the shadow to the vertex
    double SquaredOffset; // mm^2
    double A() const { return 1.0 - this->B - this->C; }
  };
  struct Visited
  {
    Index Id;
  };
  using Shape = std::array<Shadow, 3>;

  bool Begin(const std::array<Vector3, 3>& face);
  const Shadow& ShadowOf(VertexId vertex);
  bool Visit(Index triangle, double limit);
  bool Count(const Shape& shape);
  bool Cross(Index edge);
  bool IsNearOver(const Shape& shape, double limit);

  const HalfEdgeMesh& Original;
  SparseSet<Visited> Triangles;
  SparseSet<Shadow> Shadows;
  Vector3 A, AB, AC;
  Vector3 AlongB, AlongC; // 1/mm: b = AlongB . (p - A)
  double SuspectB = 0.0, SuspectC = 0.0;
  bool IsOdd = false;
};
}

#endif
