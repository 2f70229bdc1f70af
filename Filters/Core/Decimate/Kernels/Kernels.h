// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Kernels.h
 * @brief Vectorized inner loops, eight or four lanes wide, one set for each kind of processor.
 *
 * All sets give the same bits. The best one for this processor is used unless another one is
 * selected. KernelSet.h names the scalar reference of each kernel.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_Kernels_h
#define BoneDecimate_Core_Decimate_Kernels_Kernels_h

#include "Decimate/Placement/Freedom.h"
#include "Mesh/HalfEdgeMesh.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Edges from one vertex to up to eight others. The arrays are plain, because kernels must not use
/// inline functions of libraries: these would be compiled for one processor and linked for all.
struct EdgeBatch
{
  static constexpr int Size = 8;
  const VertexRecord* First = nullptr;
  const VertexRecord* Others[Size] = {};
  std::int32_t Freedoms[Size] = {};   ///< Values of type Freedom.
  float AccumulatedErrors[Size] = {}; ///< The larger accumulated error of both ends, units.
  int Count = 0;
  double PerUnit = 1.0;   ///< 1 / unit, 1/mm
  float CostFactor = 1.0; ///< CostNormalization() of Decimate/Cost/QuadricDeviation.h.
};

struct EdgeResults
{
  float Costs[EdgeBatch::Size];    ///< Infinite: not collapsed.
  float MinCost;                   ///< Smallest cost.
  float Moves[3][EdgeBatch::Size]; ///< From First, units.
};

/// The triangles around the merged vertex before and after the collapse, mm, with Start as the
/// origin.
struct Fan
{
  /// Coordinates of Ring[0 .. Faces]; the first is repeated at the end if the ring closes.
  double* Ring[3] = {};
  std::int64_t* AtEnd = {}; ///< -1 for a face at End before the collapse, 0 for one at Start.
  double* OldArea[3] = {};  ///< Twice the area vectors before, mm^2, filled by CheckFan.
  double* NewArea[3] = {};  ///< Twice the area vectors after, mm^2, filled by CheckFan.
  double End[3] = {};
  double Apexes[3][4] = {}; ///< Apexes of the removed faces, repeated to four lanes.
  double Position[3] = {};  ///< Position of the merged vertex.
  int Faces = 0;
};

/// The validity of the fan after the collapse.
struct FanValidity
{
  bool Degenerate = false;   ///< A face would have no area or become a sliver.
  bool Flip = false;         ///< A face would turn over.
  double VolumeChange = 0.0; ///< mm^3
};

/// Four triangles A, A + AB, A + AC, mm; unused lanes repeat another triangle.
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
  void (*EvaluateEdges)(const EdgeBatch& batch, EdgeResults& results);
  void (*CheckFan)(Fan& fan, FanValidity& validity);
  /// The accumulated error after the collapse, mm: the formula of Decimate/Cost/AccumulatedError.h.
  /// Needs no other kernel first.
  double (*AccumulateError)(const Fan& fan, double atStart, double atEnd);
  /// The quadric of a vertex at the origin. @param fan Only Ring is read.  @param perArea 1/mm^2
  RingQuadric (*SumPlanes)(const Fan& fan, double perArea);
  /// Adds new minus old planes to the quadrics of the ring, and returns the sum of the new ones.
  /// @param ring The vertices of the fan's ring; fewer by one than Faces + 1 if it closes.
  /// @param perArea 1/mm^2
  RingQuadric (*ExchangePlanes)(
    const Fan& fan, VertexRecord* records, const Index* ring, bool closes, double perArea);
  /// Squared distances to the triangles, mm^2: to points that are nearest up to rounding. They are
  /// too small by the rounding of one subtraction at most.
  /// @param squared Size values per batch.
  void (*ReachTriangles)(
    const TriangleBatch* batches, int count, const double* point, double* squared);
};

/// The selected set, or the best one for this processor.
const Kernels& BestKernels();
/// Selects a set, for tests and benchmarks; must not be called during a run. nullptr: the best set.
void ChooseKernels(const Kernels* kernels);
/// All sets for this processor, the best last. AVX-512 gains nothing over AVX2 at eight lanes, and
/// plain loops are faster than vector types wider than the registers of the processor.
const std::vector<const Kernels*>& AvailableKernels();
}

#endif
