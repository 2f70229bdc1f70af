// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexQuadrics.h
 * @brief What a collapse would do to the normal field, and the best place for it, from two vertex records in O(1).
 *
 * The deviation between the old and the new normal of a face, times its area and the square of its height over the
 * moved corner, is its area times the squared distance by which the corner leaves its plane. Every plane of a vertex's
 * ring passes through that vertex, so that nine numbers a vertex hold the sum over its ring:
 *
 *     M_v = sum 2 A n nT,  G_v = sum 2 A n                                                      mm^2
 *     with e = (w - v) / 2 and x the place relative to the middle of v and w:
 *     M = M_v + M_w,  r = (M_w - M_v) e,  g = G_v + G_w,  d = (G_w - G_v).e
 *     Q(x) = xT M x - 2 r.x + eT M e                                                            mm^4
 *     x0 = (M + 1e-4 tr M / 3 I)^-1 r
 *     x  = x0 + y (d - g.x0) / (g.y),  y = (M + ...)^-1 g       keeps the volume
 *     cost = S^(1/4) Q^(3/4) + 0.03 S/2 D^(3/2),  S = tr M     about sum of area times distance^1.5
 *
 * D is the memory of error: how far, at most, the vertices merged into v and w have been left behind already; without it
 * thin parts are eaten away in many small steps. Costs have no unit: S, Q and D are divided by powers of the mean edge length of
 * the cleaned input, so that scaling by a power of two changes no bit of a cost.
 *
 * Both rings hold the two faces that vanish, so that these count twice in every sum: that is the price of O(1), and the
 * volume is kept under the two rings so counted, not exactly.
 * A place farther than two edge lengths from the middle gives way to x0, then to the middle. A border edge b adds
 * 2 (|b|^2 I - b bT), its line's quadric, to both of its ends; it is collapsed to the minimum of Q along itself.
 *
 * P. Lindstrom and G. Turk, Fast and memory efficient polygonal simplification, 1998: memoryless, volume kept.
 * M. Garland and P. Heckbert, Surface simplification using quadric error metrics, 1997: quadrics.
 */
#ifndef BoneDecimate_Core_Cost_VertexQuadrics_h
#define BoneDecimate_Core_Cost_VertexQuadrics_h

#include "Mesh/FaceAreas.h"
#include "Mesh/HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class VertexQuadrics
{
public:
  /// @param unit Length by which costs are made free of units, mm.
  VertexQuadrics(const HalfEdgeMesh& mesh, const FaceAreas& areas, double unit);

  /// Sums the ring of v afresh; after a collapse for the merged vertex and its one-ring.
  void Update(Index v);

  struct Answer
  {
    double Cost = 0.0;
    Vector3 Position = Vector3::Zero(); ///< mm from the local origin
  };

  /// Where the merged vertex may go.
  enum class Freedom
  {
    Space, ///< Anywhere that keeps the volume.
    Edge,  ///< On the edge between v and w.
    First, ///< Where v is.
    Second ///< Where w is.
  };

  /// Collapsing the edge between v and w to the best place there is.
  Answer Evaluate(Index v, Index w, Freedom freedom) const;

  /// Distance left behind so far by what was merged into v, mm.
  double MemoryOf(Index v) const { return this->Memories[v]; }
  void Remember(Index v, double distance) { this->Memories[v] = distance; }

private:
  /// xx xy xz yy yz zz of a symmetric matrix.
  using Symmetric = std::array<double, 6>;
  struct Record
  {
    Symmetric M{};               // mm^2
    Vector3 G = Vector3::Zero(); // mm^2
  };
  static Vector3 Times(const Symmetric& m, const Vector3& x);
  static bool Invert(const Symmetric& m, Symmetric& inverse);
  static void AddPlane(Record& record, const FaceAreas::Face& face);
  static void AddBorderEdge(Record& record, const Vector3& edge);
  double CostOf(double s, double q, double left) const;
  static Vector3 PlaceInSpace(const Record& sum, const Vector3& r, double d, const Vector3& half);
  static Vector3 PlaceOnEdge(const Record& sum, const Vector3& r, const Vector3& half);

  const HalfEdgeMesh& Mesh;
  const FaceAreas& Areas;
  double Unit;
  std::vector<Record> Records;
  std::vector<double> Memories; // mm
};
}

#endif
