// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelSet.h
 * @brief The kernels themselves; compiled once for each kind of processor, see Kernels.h.
 *
 * **An edge** between v and w, in coordinates about its middle, e = (w - v) / 2, with M and G of both ends summed over
 * the triangles as they are now (RingQuadric):
 *
 *     M = Mv + Mw      r = (Mw - Mv) e      g = Gv + Gw      d = (Gw - Gv) . e
 *     x0 = (M + 1e-5 tr M / 3 I)^-1 r                                    least squared distance to the planes
 *     y  = (M + 1e-5 tr M / 3 I)^-1 g,   x = x0 + y (d - g.x0) / (g.y)   the same, volume kept
 *     |x| > 2 lengths: x0; that too far as well: the middle
 *     Q = x.Mx - 2 r.x + e.Me,   S = tr M,   cost = S^(1/4) Q^(3/4) + 0.03 (S / 2) D^(3/2)
 *
 * The first term is about area times distance^(3/2), the deviation of the normals of the faces that stay, old against
 * new, weighted by area and height. D is the distance left behind by earlier collapses at either end. In flat places Q
 * is lifted to a rounding's worth of S length^2, so that shorter edges go first. On open borders M holds
 * 2 |b|^2 (I - bb^T/|b|^2) for each border edge b at both its ends.
 *
 * P. Lindstrom, G. Turk, Fast and memory efficient polygonal simplification, 1998: memoryless quadrics, volume kept.
 */
#include "FaceRules.h"
#include "Kernels.h"
#include "LaneDistance.h"
#include "Lanes.h"
#include "ReachKernel.h"

#include <limits>

namespace bonedecimate
{
namespace
{
constexpr float Ridge = 1e-5F; // of the mean eigenvalue of M
constexpr float MemoryWeight = 0.03F;
constexpr float FlatShare = 1e-8F;    // of S length^2
constexpr float FarthestMove = 16.0F; // (2 lengths)^2 in squares of half a length

/// Records of one vertex, side by side.
struct Ends
{
  Vectors<Floats> Half; // from First to Other, half of it, units
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

inline const float* QuadricOf(const VertexRecord* record)
{
  return reinterpret_cast<const float*>(&record->Quadric); // M, then G
}

/// From one position to another, times the scale; the fourth is of no meaning.
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

/// The place of least Q that keeps the volume, from the middle.
inline Vectors<Floats> PlaceInSpace(const EdgeSystem& s, Floats halfSquared)
{
  const Floats ridge = s.Trace * (Ridge / 3.0F);
  const Symmetric<Floats> m = { s.M.XX + ridge, s.M.XY, s.M.XZ, s.M.YY + ridge, s.M.YZ,
    s.M.ZZ + ridge };
  const Symmetric<Floats> adjugate = m.Adjugate();
  const Floats perDeterminant = 1.0F / m.Determinant(adjugate);
  const Vectors<Floats> free = (adjugate * s.R) * perDeterminant;
  const Vectors<Floats> y = (adjugate * s.G) * perDeterminant;
  const Vectors<Floats> kept = free + y * ((s.D - s.G.Dot(free)) / s.G.Dot(y));
  const Floats farthest = halfSquared * FarthestMove;
  const Vectors<Floats> middle = { farthest * 0.0F, farthest * 0.0F, farthest * 0.0F };
  // What is not a number is not near either.
  const Vectors<Floats> fallback = Select(free.Dot(free) <= farthest, free, middle);
  return Select(kept.Dot(kept) <= farthest, kept, fallback);
}

inline Vectors<Floats> PlaceOnEdge(const EdgeSystem& s, const Vectors<Floats>& half)
{
  const Floats curvature = half.Dot(s.M * half);
  Floats t = s.R.Dot(half) / curvature;
  const Floats zero = {};
  t = Select(t < 1.0F, t, zero + 1.0F);
  t = Select(t > -1.0F, t, zero - 1.0F);
  return half * Select(curvature > 0.0F, t, zero);
}

void JudgeEdges(const EdgeBatch& batch, EdgeAnswers& answers)
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
  Vectors<Floats> x = PlaceInSpace(s, halfSquared);
  if (Any(freedom != static_cast<std::int32_t>(Freedom::Space)))
  {
    x = Select(freedom == static_cast<std::int32_t>(Freedom::Edge), PlaceOnEdge(s, half), x);
    x = Select(freedom == static_cast<std::int32_t>(Freedom::First), half * (zero - 1.0F), x);
    x = Select(freedom == static_cast<std::int32_t>(Freedom::Second), half, x);
  }
  const Floats flat = s.Trace * halfSquared * FlatShare;
  const Floats squares =
    Larger(x.Dot(s.M * x) - 2.0F * s.R.Dot(x) + half.Dot(s.M * half), zero) + flat;
  const Floats memory = Load<Floats>(batch.Memories);
  const Floats cost = (Root(Root(s.Trace) * squares * Root(squares)) +
                        (0.5F * MemoryWeight) * s.Trace * memory * Root(memory)) *
    batch.CostFactor;
  const float never = std::numeric_limits<float>::infinity();
  const FloatMask counts =
    (freedom != static_cast<std::int32_t>(Freedom::Nowhere)) & (cost < never);
  const Floats costs = Select(counts, cost, zero + never);
  Store(costs, answers.Costs);
  answers.Least = LeastOf(costs);
  Store(half.X + x.X, answers.Moves[0]);
  Store(half.Y + x.Y, answers.Moves[1]);
  Store(half.Z + x.Z, answers.Moves[2]);
}

//------------------------------------------------------------------------------
inline Vectors<Doubles> LoadVectors(double* const (&from)[3], int at)
{
  return { Load<Doubles>(from[0] + at), Load<Doubles>(from[1] + at), Load<Doubles>(from[2] + at) };
}
inline void StoreVectors(const Vectors<Doubles>& v, double* const (&to)[3], int at)
{
  Store(v.X, to[0] + at);
  Store(v.Y, to[1] + at);
  Store(v.Z, to[2] + at);
}
inline Vectors<Doubles> All(const double (&v)[3])
{
  const Doubles zero = {};
  return { zero + v[0], zero + v[1], zero + v[2] };
}
/// Lanes that hold a face of the fan.
inline DoubleMask IsFace(int at, int faces)
{
  const DoubleMask lane = { 0, 1, 2, 3 };
  return lane < static_cast<std::int64_t>(faces - at);
}

inline Doubles QualityOf(Doubles twiceArea, Doubles squares)
{
  return (0.5 * QualityOfEquilateral) * twiceArea / squares;
}

void JudgeFan(Fan& fan, FanVerdict& verdict)
{
  const Doubles zero = {};
  const Vectors<Doubles> end = All(fan.End);
  const Vectors<Doubles> start = { zero, zero, zero };
  const Vectors<Doubles> place = All(fan.Place);
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
    const Vectors<Doubles> newArm = second - place;
    const Vectors<Doubles> before = oldArm.Cross(side);
    const Vectors<Doubles> after = newArm.Cross(side);
    StoreVectors(before, fan.OldArea, i);
    StoreVectors(after, fan.NewArea, i);
    const Doubles areaBefore = Root(before.Dot(before));
    const Doubles areaAfter = Root(after.Dot(after));
    const Vectors<Doubles> oldThird = third - corner;
    const Vectors<Doubles> newThird = third - place;
    const Doubles sideSquared = side.Dot(side);
    const Doubles qualityAfter =
      QualityOf(areaAfter, sideSquared + newArm.Dot(newArm) + newThird.Dot(newThird));
    const Doubles squaresBefore = sideSquared + oldArm.Dot(oldArm) + oldThird.Dot(oldThird);
    const Doubles qualityBefore =
      Select(squaresBefore > 0.0, QualityOf(areaBefore, squaresBefore), zero);
    const DoubleMask hasArea = areaAfter > 0.0; // false for what is not a number, too
    degenerate |= isFace &
      (~hasArea | ((qualityAfter < LeastQualityOfCollapse) & (qualityAfter < qualityBefore)));
    flip |=
      isFace & (areaBefore > 0.0) & (before.Dot(after) < LeastCosine * (areaBefore * areaAfter));
    const Doubles change = (after - before).Dot(second);
    volume += Select(isFace, change, zero);
  }
  verdict.Degenerate = Any(degenerate);
  verdict.Flip = Any(flip);
  verdict.VolumeChange = (volume[0] + volume[1] + volume[2] + volume[3]) / 6.0;
}

//------------------------------------------------------------------------------
/// Distance of a point to the fan after the collapse, mm.
inline double DistanceToNewFan(const Fan& fan, const double (&from)[3])
{
  const Vectors<Doubles> point = All(from);
  const Vectors<Doubles> place = All(fan.Place) - point;
  const Doubles far = Doubles{} + std::numeric_limits<double>::infinity();
  Doubles least = far;
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Doubles squared = SquaredDistanceToTriangle(
      place, LoadVectors(fan.Ring, i) - point, LoadVectors(fan.Ring, i + 1) - point);
    least = Smaller(Select(IsFace(i, fan.Faces), squared, far), least);
  }
  return Root(LeastOfDoubles(least));
}

/// Distance of the future vertex to the faces at both ends as they are before the collapse, mm.
inline double DistanceToOldFan(const Fan& fan)
{
  const Vectors<Doubles> place = All(fan.Place);
  const Vectors<Doubles> start = Vectors<Doubles>{} - place;
  const Vectors<Doubles> end = All(fan.End) - place;
  const Vectors<Doubles> apex = { Load<Doubles>(fan.Apexes[0]), Load<Doubles>(fan.Apexes[1]),
    Load<Doubles>(fan.Apexes[2]) };
  const Doubles far = Doubles{} + std::numeric_limits<double>::infinity();
  Doubles least = SquaredDistanceToTriangle(start, end, apex - place);
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Vectors<Doubles> corner = Select(Load<DoubleMask>(fan.AtEnd + i), end, start);
    const Doubles squared = SquaredDistanceToTriangle(
      corner, LoadVectors(fan.Ring, i) - place, LoadVectors(fan.Ring, i + 1) - place);
    least = Smaller(Select(IsFace(i, fan.Faces), squared, far), least);
  }
  return Root(LeastOfDoubles(least));
}

double LeaveBehind(const Fan& fan, double atStart, double atEnd)
{
  const double start[3] = { 0.0, 0.0, 0.0 };
  const double first = atStart + DistanceToNewFan(fan, start);
  const double second = atEnd + DistanceToNewFan(fan, fan.End);
  const double ends = first > second ? first : second;
  const double place = (atStart > atEnd ? atStart : atEnd) + DistanceToOldFan(fan);
  return ends > place ? ends : place;
}

//------------------------------------------------------------------------------
/// Adds sign * (2 A n n^T, 2 A n) of four faces to nine sums.
inline void AddPlanes(const Vectors<Doubles>& n, Doubles sign, Doubles (&sums)[9])
{
  const Doubles length = Root(n.Dot(n));
  const Doubles weight = Select(length > 0.0, sign / length, length);
  const Vectors<Doubles> scaled = n * weight;
  sums[0] += scaled.X * n.X;
  sums[1] += scaled.X * n.Y;
  sums[2] += scaled.X * n.Z;
  sums[3] += scaled.Y * n.Y;
  sums[4] += scaled.Y * n.Z;
  sums[5] += scaled.Z * n.Z;
  sums[6] += sign * n.X;
  sums[7] += sign * n.Y;
  sums[8] += sign * n.Z;
}

inline RingQuadric SumOfLanes(const Doubles (&sums)[9])
{
  RingQuadric quadric;
  float* to = reinterpret_cast<float*>(&quadric);
  for (int k = 0; k < 9; ++k)
  {
    to[k] = static_cast<float>((sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3]));
  }
  return quadric;
}

RingQuadric SumPlanes(const Fan& fan, double perArea)
{
  const Doubles zero = {};
  Doubles sums[9] = {};
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Vectors<Doubles> n = LoadVectors(fan.Ring, i).Cross(LoadVectors(fan.Ring, i + 1));
    AddPlanes(n, Select(IsFace(i, fan.Faces), zero + perArea, zero), sums);
  }
  return SumOfLanes(sums);
}

/// What four faces change in the quadrics at their ends, a row for each face: eight numbers and the ninth.
struct Changes
{
  Floats Eight[NumberOfDoubles];
  FourFloats Ninth;
};

inline Changes RowsOf(const Doubles (&sums)[9])
{
  Changes rows;
  for (int k = 0; k < NumberOfDoubles; ++k)
  {
    rows.Eight[k] = Join(ToFloats(sums[k]), ToFloats(sums[k + NumberOfDoubles]));
  }
  TransposeHalves(rows.Eight);
  rows.Ninth = ToFloats(sums[8]);
  return rows;
}

/// A quadric on its way through the registers.
struct NineFloats
{
  Floats Eight;
  float Ninth;
  NineFloats operator+(const NineFloats& o) const { return { Eight + o.Eight, Ninth + o.Ninth }; }
};

inline NineFloats LoadQuadric(const VertexRecord& record)
{
  const float* from = QuadricOf(&record);
  return { Load<Floats>(from), from[8] };
}
inline void StoreQuadric(const NineFloats& quadric, VertexRecord& record)
{
  float* to = reinterpret_cast<float*>(&record.Quadric);
  Store(quadric.Eight, to);
  to[8] = quadric.Ninth;
}

/// Every vertex of the ring gets the change of the face before it and then that of the face behind it.
RingQuadric ExchangePlanes(
  const Fan& fan, VertexRecord* records, const Index* ring, bool closes, double perArea)
{
  const Doubles zero = {};
  Doubles sums[9] = {};
  NineFloats before = {};
  for (int i = 0; i < fan.Faces; i += NumberOfDoubles)
  {
    const Doubles weight = Select(IsFace(i, fan.Faces), zero + perArea, zero);
    Doubles changes[9] = {};
    AddPlanes(LoadVectors(fan.NewArea, i), weight, changes);
    for (int k = 0; k < 9; ++k)
    {
      sums[k] += changes[k];
    }
    AddPlanes(LoadVectors(fan.OldArea, i), zero - weight, changes);
    const Changes rows = RowsOf(changes);
    const int faces = fan.Faces - i < NumberOfDoubles ? fan.Faces - i : NumberOfDoubles;
    for (int lane = 0; lane < faces; ++lane)
    {
      VertexRecord& record = records[ring[i + lane]];
      const NineFloats change = { rows.Eight[lane], rows.Ninth[lane] };
      const NineFloats old = LoadQuadric(record);
      StoreQuadric((i + lane > 0 ? old + before : old) + change, record);
      before = change;
    }
  }
  VertexRecord& last = records[ring[closes ? 0 : fan.Faces]];
  StoreQuadric(LoadQuadric(last) + before, last);
  return SumOfLanes(sums);
}
}

extern const Kernels BONEDECIMATE_KERNELS;
const Kernels BONEDECIMATE_KERNELS = { BONEDECIMATE_KERNELS_NAME, JudgeEdges, JudgeFan, LeaveBehind,
  SumPlanes, ExchangePlanes, ReachTriangles };
}
