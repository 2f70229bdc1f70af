// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneSums.h
 * @brief A part of KernelSet.h: the quadrics of the planes of a fan, computed anew or updated after
 * a collapse.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_PlaneSums_h
#define BoneDecimate_Core_Decimate_Kernels_PlaneSums_h

#include "FanLanes.h"
#include "Kernels.h"

namespace bonedecimate
{
namespace
{
inline const float* QuadricOf(const VertexRecord* record)
{
  return reinterpret_cast<const float*>(&record->Quadric); // M, then G
}

/// Adds sign * (2 A n n^T, 2 A n) of four faces to nine sums, a lane per face.
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

/// The changes of the quadrics by four faces. A row has eight of the nine numbers of a face.
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

/// A quadric in registers.
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

/// Adds the changes of both faces at each vertex of the ring to its quadric, first that of the
/// previous face.
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
}

#endif
