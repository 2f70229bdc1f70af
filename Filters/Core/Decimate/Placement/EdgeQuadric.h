// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeQuadric.h
 * @brief The squared distance to the planes of the triangles at both ends of an edge, as a quadric
 * about its middle.
 *
 * For the edge from v to w, with the sums over the triangles at each end (RingQuadric: area A, unit
 * normal n)
 *
 *     Mv = sum of 2 A n n^T,   gv = sum of 2 A n
 *
 * and coordinates relative to the middle, with e = (w - v) / 2:
 *
 *     M = Mv + Mw      r = (Mw - Mv) e      g = gv + gw      d = (gw - gv) . e
 *     Q(x) = x.Mx - 2 r.x + e.Me    sum over the planes of 2 A times the squared distance
 *     g.x = d                       the plane on which the volume under both rings is preserved
 *
 * All planes of a ring pass through its vertex, so nine numbers suffice. Lengths are in the unit of
 * the mesh. Everything is in single precision and added from left to right, so the kernels give the
 * same bits.
 *
 * M. Garland, P. Heckbert, Surface simplification using quadric error metrics, 1997: the quadric.
 * P. Lindstrom, G. Turk, Fast and memory efficient polygonal simplification, 1998: from the current
 * triangles instead of accumulated.
 */
#ifndef BoneDecimate_Core_Decimate_Placement_EdgeQuadric_h
#define BoneDecimate_Core_Decimate_Placement_EdgeQuadric_h

#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
struct Float3
{
  float X, Y, Z;

  Float3 operator+(const Float3& o) const { return { X + o.X, Y + o.Y, Z + o.Z }; }
  Float3 operator-(const Float3& o) const { return { X - o.X, Y - o.Y, Z - o.Z }; }
  Float3 operator*(float s) const { return { X * s, Y * s, Z * s }; }
  float Dot(const Float3& o) const { return X * o.X + Y * o.Y + Z * o.Z; }
};

/// A symmetric 3 x 3 matrix.
struct SymmetricFloat3
{
  float XX, XY, XZ, YY, YZ, ZZ;

  Float3 operator*(const Float3& v) const
  {
    return { XX * v.X + XY * v.Y + XZ * v.Z, XY * v.X + YY * v.Y + YZ * v.Z,
      XZ * v.X + YZ * v.Y + ZZ * v.Z };
  }
  float Trace() const { return XX + YY + ZZ; }
};

struct EdgeQuadric
{
  Float3 Half;       ///< e, units.
  SymmetricFloat3 M; ///< Squares of the unit.
  Float3 R;          ///< Cubes of the unit.
  Float3 G;          ///< Squares of the unit.
  float D;           ///< Cubes of the unit.

  /// Q(x), units to the power of 4. Rounding may make it negative.
  float At(const Float3& x) const
  {
    return x.Dot(this->M * x) - 2.0F * this->R.Dot(x) + this->Half.Dot(this->M * this->Half);
  }
};

/// The quadric from the records of both ends. @param perUnit 1 / unit, 1/mm.
EdgeQuadric QuadricOfEdge(const VertexRecord& first, const VertexRecord& second, double perUnit);
}

#endif
