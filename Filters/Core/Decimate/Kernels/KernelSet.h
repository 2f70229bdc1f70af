// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelSet.h
 * @brief The kernels. This file is compiled once for each kind of processor (Kernels.h).
 *
 *     EvaluateEdges      EdgeQuadric.h, VolumePreserving.h, QuadricDeviation.h; eight edges
 *     AccumulateError    AccumulatedError.h; four triangles
 *
 * These files have the formulas, their sources and a scalar reference, whose bits every set of
 * kernels gives.
 */
#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Placement/VolumePreserving.h"
#include "FaceRules.h"
#include "FanLanes.h"
#include "Kernels.h"
#include "LaneDistance.h"
#include "Lanes.h"
#include "PlaneSums.h"
#include "ReachKernel.h"

#include <cstdint>
#include <limits>

namespace bonedecimate
{
namespace
{
/// The records of eight edges, one to a lane.
struct Ends
{
  Vectors<Floats> Half; // half of the vector from First to Other, units
  Symmetric<Floats> M;
  Vectors<Floats> G;
};

inline Symmetric<Floats> operator+(const Symmetric<Floats>& a, const Symmetric<Floats>& b)
{
  return { a.XX + b.XX, a.XY + b.XY, a.XZ + b.XZ, a.YY + b.YY, a.YZ + b.YZ, a.ZZ + b.ZZ };
}
inline Symmetric<Floats> operator-(const Symmetric<Floats>& a, const Symmetric<Floats>& b)
{
  return { a.XX - b.XX, a.XY - b.XY, a.XZ - b.XZ, a.YY - b.YY, a.YZ - b.YZ, a.ZZ - b.ZZ };
}

inline const double* CoordinatesOf(const VertexRecord* record)
{
  return reinterpret_cast<const double*>(record);
}

/// Scaled vector from one position to another; the fourth component is meaningless.
inline FourFloats Arm(const VertexRecord* to, Doubles from, double scale)
{
  return ToFloats((Load<Doubles>(CoordinatesOf(to)) - from) * scale);
}

inline Ends LoadEnds(const EdgeBatch& batch)
{
  const VertexRecord* records[8];
  for (int i = 0; i < 8; ++i)
  {
    records[i] = i < batch.Count ? batch.Others[i] : batch.First;
  }
  Floats rows[8];
  for (int i = 0; i < 8; ++i)
  {
    rows[i] = Load<Floats>(QuadricOf(records[i]));
  }
  Transpose(rows);
  const Doubles first = Load<Doubles>(CoordinatesOf(batch.First));
  const double scale = 0.5 * batch.PerUnit;
  Floats half[4];
  for (int i = 0; i < 4; ++i)
  {
    half[i] = Join(Arm(records[i], first, scale), Arm(records[i + 4], first, scale));
  }
  TransposeHalves(half);
  const auto last = [&](int i) { return QuadricOf(records[i])[8]; };
  return { { half[0], half[1], half[2] }, { rows[0], rows[1], rows[2], rows[3], rows[4], rows[5] },
    { rows[6], rows[7],
      Floats{ last(0), last(1), last(2), last(3), last(4), last(5), last(6), last(7) } } };
}

struct EdgeSystem
{
  Symmetric<Floats> M;
  Vectors<Floats> R, G;
  Floats D, Trace;
};

/// The position relative to the middle that minimizes Q and preserves the volume.
inline Vectors<Floats> PositionInSpace(const EdgeSystem& s, Floats halfSquared)
{
  const Floats ridge = s.Trace * (QuadricRidge / 3.0F);
  const Symmetric<Floats> m = { s.M.XX + ridge, s.M.XY, s.M.XZ, s.M.YY + ridge, s.M.YZ,
    s.M.ZZ + ridge };
  const Symmetric<Floats> adjugate = m.Adjugate();
  const Floats perDeterminant = 1.0F / m.Determinant(adjugate);
  const Vectors<Floats> free = (adjugate * s.R) * perDeterminant;
  const Vectors<Floats> y = (adjugate * s.G) * perDeterminant;
  const Vectors<Floats> kept = free + y * ((s.D - s.G.Dot(free)) / s.G.Dot(y));
  const Floats farthest = halfSquared * FarthestMoveSquared;
  const Vectors<Floats> middle = { farthest * 0.0F, farthest * 0.0F, farthest * 0.0F };
  // NaN is treated as too far.
  const Vectors<Floats> fallback = Select(free.Dot(free) <= farthest, free, middle);
  return Select(kept.Dot(kept) <= farthest, kept, fallback);
}

inline Vectors<Floats> PositionOnEdge(const EdgeSystem& s, const Vectors<Floats>& half)
{
  const Floats curvature = half.Dot(s.M * half);
  Floats t = s.R.Dot(half) / curvature;
  const Floats zero = {};
  t = Select(t < 1.0F, t, zero + 1.0F);
  t = Select(t > -1.0F, t, zero - 1.0F);
  return half * Select(curvature > 0.0F, t, zero);
}

void EvaluateEdges(const EdgeBatch& batch, EdgeResults& results)
{
  const Ends ends = LoadEnds(batch);
  const float* q = QuadricOf(batch.First);
  const Floats zero = {};
  const Symmetric<Floats> firstM = { zero + q[0], zero + q[1], zero + q[2], zero + q[3],
    zero + q[4], zero + q[5] };
  const Vectors<Floats> firstG = { zero + q[6], zero + q[7], zero + q[8] };
  const Vectors<Floats>& half = ends.Half;
  const Floats halfSquared = half.Dot(half);
  EdgeSystem s;
  s.M = firstM + ends.M;
  s.R = (ends.M - firstM) * half;
  s.G = firstG + ends.G;
  s.D = (ends.G - firstG).Dot(half);
  s.Trace = s.M.XX + s.M.YY + s.M.ZZ;

  const FloatMask freedom = Load<FloatMask>(batch.Freedoms);
  Vectors<Floats> x = PositionInSpace(s, halfSquared);
  if (Any(freedom != static_cast<std::int32_t>(Freedom::Space)))
  {
    x = Select(freedom == static_cast<std::int32_t>(Freedom::Edge), PositionOnEdge(s, half), x);
    x = Select(freedom == static_cast<std::int32_t>(Freedom::First), half * (zero - 1.0F), x);
    x = Select(freedom == static_cast<std::int32_t>(Freedom::Second), half, x);
  }
  const Floats flat = s.Trace * halfSquared * FlatRatio;
  const Floats squares =
    Larger(x.Dot(s.M * x) - 2.0F * s.R.Dot(x) + half.Dot(s.M * half), zero) + flat;
  const Floats memory = Load<Floats>(batch.AccumulatedErrors);
  const Floats cost = (Root(Root(s.Trace) * squares * Root(squares)) +
                        (0.5F * AccumulatedErrorWeight) * s.Trace * memory * Root(memory)) *
    batch.CostFactor;
  const float never = std::numeric_limits<float>::infinity();
  const FloatMask counts =
    (freedom != static_cast<std::int32_t>(Freedom::Nowhere)) & (cost < never);
  const Floats costs = Select(counts, cost, zero + never);
  Store(costs, results.Costs);
  results.MinCost = MinOf(costs);
  Store(half.X + x.X, results.Moves[0]);
  Store(half.Y + x.Y, results.Moves[1]);
  Store(half.Z + x.Z, results.Moves[2]);
}

//------------------------------------------------------------------------------
inline Doubles QualityOf(Doubles twiceArea, Doubles squares)
{
  return (0.5 * QualityOfEquilateral) * twiceArea / squares;
}

void CheckFan(Fan& fan, FanValidity& validity)
{
  const Doubles zero = {};
  const Vectors<Doubles> end = All(fan.End);
  const Vectors<Doubles> start = { zero, zero, zero };
  const Vectors<Doubles> position = All(fan.Position);
  Doubles volume = zero;
  DoubleMask degenerate = {};
  DoubleMask flip = {};
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const DoubleMask isFace = IsFace(i, fan.Faces);
    const Vectors<Doubles> second = LoadVectors(fan.Ring, i);
    const Vectors<Doubles> third = LoadVectors(fan.Ring, i + 1);
    const Vectors<Doubles> corner = Select(Load<DoubleMask>(fan.AtEnd + i), end, start);
    const Vectors<Doubles> side = third - second;
    const Vectors<Doubles> oldArm = second - corner;
    const Vectors<Doubles> newArm = second - position;
    const Vectors<Doubles> before = oldArm.Cross(side);
    const Vectors<Doubles> after = newArm.Cross(side);
    StoreVectors(before, fan.OldArea, i);
    StoreVectors(after, fan.NewArea, i);
    const Doubles areaBefore = Root(before.Dot(before));
    const Doubles areaAfter = Root(after.Dot(after));
    const Vectors<Doubles> oldThird = third - corner;
    const Vectors<Doubles> newThird = third - position;
    const Doubles sideSquared = side.Dot(side);
    const Doubles qualityAfter =
      QualityOf(areaAfter, sideSquared + newArm.Dot(newArm) + newThird.Dot(newThird));
    const Doubles squaresBefore = sideSquared + oldArm.Dot(oldArm) + oldThird.Dot(oldThird);
    const Doubles qualityBefore =
      Select(squaresBefore > 0.0, QualityOf(areaBefore, squaresBefore), zero);
    const DoubleMask hasArea = areaAfter > 0.0; // false for NaN, too
    degenerate |= isFace &
      (~hasArea |
        ((qualityAfter < MinQualityOfCollapse) &
          (qualityAfter < MinRatioOfQuality * qualityBefore)));
    flip |=
      isFace & (areaBefore > 0.0) & (before.Dot(after) < MinCosine * (areaBefore * areaAfter));
    const Doubles change = (after - before).Dot(second);
    volume += Select(isFace, change, zero);
  }
  validity.Degenerate = Any(degenerate);
  validity.Flip = Any(flip);
  validity.VolumeChange = (volume[0] + volume[1] + volume[2] + volume[3]) / 6.0;
}

//------------------------------------------------------------------------------
/// Distance of a point to the fan after the collapse, mm.
inline double DistanceToNewFan(const Fan& fan, const double (&from)[3])
{
  const Vectors<Doubles> point = All(from);
  const Vectors<Doubles> position = All(fan.Position) - point;
  const Doubles far = Doubles{} + std::numeric_limits<double>::infinity();
  Doubles least = far;
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Doubles squared = SquaredDistanceToTriangle(
      position, LoadVectors(fan.Ring, i) - point, LoadVectors(fan.Ring, i + 1) - point);
    least = Smaller(Select(IsFace(i, fan.Faces), squared, far), least);
  }
  return Root(MinOfDoubles(least));
}

/// Distance of the merged vertex to the faces at both ends before the collapse, mm.
inline double DistanceToOldFan(const Fan& fan)
{
  const Vectors<Doubles> position = All(fan.Position);
  const Vectors<Doubles> start = Vectors<Doubles>{} - position;
  const Vectors<Doubles> end = All(fan.End) - position;
  const Vectors<Doubles> apex = { Load<Doubles>(fan.Apexes[0]), Load<Doubles>(fan.Apexes[1]),
    Load<Doubles>(fan.Apexes[2]) };
  const Doubles far = Doubles{} + std::numeric_limits<double>::infinity();
  Doubles least = SquaredDistanceToTriangle(start, end, apex - position);
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Vectors<Doubles> corner = Select(Load<DoubleMask>(fan.AtEnd + i), end, start);
    const Doubles squared = SquaredDistanceToTriangle(
      corner, LoadVectors(fan.Ring, i) - position, LoadVectors(fan.Ring, i + 1) - position);
    least = Smaller(Select(IsFace(i, fan.Faces), squared, far), least);
  }
  return Root(MinOfDoubles(least));
}

double AccumulateError(const Fan& fan, double atStart, double atEnd)
{
  const double start[3] = { 0.0, 0.0, 0.0 };
  const double first = atStart + DistanceToNewFan(fan, start);
  const double second = atEnd + DistanceToNewFan(fan, fan.End);
  const double ends = first > second ? first : second;
  const double atMerged = (atStart > atEnd ? atStart : atEnd) + DistanceToOldFan(fan);
  return ends > atMerged ? ends : atMerged;
}
}

extern const Kernels BONEDECIMATE_KERNELS;
const Kernels BONEDECIMATE_KERNELS = { BONEDECIMATE_KERNELS_NAME, EvaluateEdges, CheckFan,
  AccumulateError, SumPlanes, ExchangePlanes, ReachTriangles };
}
