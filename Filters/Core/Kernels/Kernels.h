// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Kernels.h
 * @brief The inner loops that are computed eight or four at a time, one set for each kind of processor.
 *
 * All sets give the same bits; the best one that this processor runs is taken unless another is asked for.
 * The formulas stand in KernelSet.h, which is compiled once for each set.
 */
#ifndef BoneDecimate_Core_Kernels_Kernels_h
#define BoneDecimate_Core_Kernels_Kernels_h

#include "Mesh/HalfEdgeMesh.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Where the merged vertex of an edge may go.
enum class Freedom : std::int32_t
{
  Space,  ///< Anywhere that keeps the volume.
  Edge,   ///< On the edge.
  First,  ///< Where the first end is.
  Second, ///< Where the second end is.
  Nowhere ///< The edge may not be collapsed.
};

/// Edges from one vertex to up to eight others. Plain arrays: kernels must not use inline functions of libraries, which
/// would be compiled for one processor and linked for all.
struct EdgeBatch
{
  static constexpr int Size = 8;
  const VertexRecord* First = nullptr;
  const VertexRecord* Others[Size] = {};
  std::int32_t Freedoms[Size] = {}; ///< Of type Freedom.
  float Memories[Size] = {}; ///< The larger distance left behind so far at either end, units.
  int Count = 0;
  double PerUnit = 1.0;   ///< 1 / unit, 1/mm
  float CostFactor = 1.0; ///< Makes costs independent of how the unit was rounded.
};

struct EdgeAnswers
{
  float Costs[EdgeBatch::Size];    ///< Infinite: never.
  float Least;                     ///< Of the costs.
  float Moves[3][EdgeBatch::Size]; ///< From First, units.
};

/// The triangles round a future vertex, before and after, mm with Start as the origin.
struct Fan
{
  double*
    Ring[3] = {}; ///< Coordinates of Ring[0 .. Faces]; the first once more at the end if it closes.
  std::int64_t* AtEnd = {}; ///< -1 where a face hangs on End today, 0 where on Start.
  double* OldArea[3] = {};  ///< Twice the area vectors before, mm^2, filled by JudgeFan.
  double* NewArea[3] = {};  ///< Twice the area vectors after, mm^2, filled by JudgeFan.
  double End[3] = {};
  double Apexes[3][4] = {}; ///< Of the faces that go with the edge; all four of one or the other.
  double Place[3] = {};     ///< Of the future vertex.
  int Faces = 0;
};

/// What would be wrong with the fan after the collapse.
struct FanVerdict
{
  bool Degenerate = false;   ///< A face would have no area or become a sliver.
  bool Flip = false;         ///< A face would turn over.
  double VolumeChange = 0.0; ///< mm^3
};

/// Four triangles A, A + AB, A + AC side by side, mm; those that are not there repeat another.
struct TriangleBatch
{
  static constexpr int Size = 4;
  double A[3][Size], AB[3][Size], AC[3][Size];
  double Bb[Size], Bc[Size], Cc[Size]; ///< AB . AB, AB . AC, AC . AC, mm^2
  double PerDeterminant[Size]; ///< 1 / (Bb Cc - Bc Bc), mm^-4; 0 for a triangle without a plane.
  double PerSquared[3][Size];  ///< 1 / squared length of AB, AC, BC; 0 without a length, mm^-2
};

struct Kernels
{
  const char* Name;
  void (*JudgeEdges)(const EdgeBatch& batch, EdgeAnswers& answers);
  void (*JudgeFan)(Fan& fan, FanVerdict& verdict);
  /// How far the collapse leaves the surface behind, together with what was left behind at its ends before, mm: the
  /// farthest of either end to the new fan and of the place to the old one. Needs no other kernel first.
  double (*LeaveBehind)(const Fan& fan, double atStart, double atEnd);
  /// The quadric of a vertex at the origin.  @param fan Only Ring is read.  @param perArea 1/mm^2
  RingQuadric (*SumPlanes)(const Fan& fan, double perArea);
  /// Adds new minus old planes to the quadrics of the ring, and returns the sum of the new ones.
  /// @param ring The vertices of the fan's ring; fewer by one than Faces + 1 if it closes.  @param perArea 1/mm^2
  RingQuadric (*ExchangePlanes)(
    const Fan& fan, VertexRecord* records, const Index* ring, bool closes, double perArea);
  /// Squared distances of a point to places on the triangles, the nearest but for rounding, mm^2: never too small by more
  /// than the rounding of one subtraction.  @param squared Size for each batch.
  void (*ReachTriangles)(
    const TriangleBatch* batches, int count, const double* point, double* squared);
};

/// The best set for this processor, unless another one was chosen.
const Kernels& BestKernels();
/// For tests and benchmarks, while nothing runs. nullptr: the best again.
void ChooseKernels(const Kernels* kernels);
/// All sets that this processor runs, the one to use last: AVX-512 gains nothing over AVX2 at eight lanes, and plain loops
/// beat vector types that the processor has to take apart.
const std::vector<const Kernels*>& AvailableKernels();
}

#endif
