// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReachKernel.h
 * @brief A part of KernelSet.h: distances of a point to four triangles at once.
 *
 * Computes the weights of the nearest point, inside or on a side, and measures the distance to the
 * point with these weights. Whatever their rounding error, that point lies on the triangle.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_ReachKernel_h
#define BoneDecimate_Core_Decimate_Kernels_ReachKernel_h

#include "Kernels.h"
#include "Lanes.h"

namespace bonedecimate
{
namespace
{
inline Vectors<Doubles> LoadBatch(const double (&from)[3][TriangleBatch::Size])
{
  return { Load<Doubles>(from[0]), Load<Doubles>(from[1]), Load<Doubles>(from[2]) };
}

inline Doubles ReachFour(const TriangleBatch& t, const Vectors<Doubles>& point)
{
  const Doubles zero = {};
  const Doubles one = zero + 1.0;
  const Vectors<Doubles> ab = LoadBatch(t.AB);
  const Vectors<Doubles> ac = LoadBatch(t.AC);
  const Vectors<Doubles> p = point - LoadBatch(t.A);
  const Doubles bb = Load<Doubles>(t.Bb);
  const Doubles bc = Load<Doubles>(t.Bc);
  const Doubles cc = Load<Doubles>(t.Cc);
  const Doubles per = Load<Doubles>(t.PerDeterminant);
  const Doubles pb = ab.Dot(p);
  const Doubles pc = ac.Dot(p);
  const Doubles b = (cc * pb - bc * pc) * per;
  const Doubles c = (bb * pc - bc * pb) * per;
  const auto clamp = [&](Doubles x) { return Smaller(Larger(x, zero), one); };
  const Doubles onAb = clamp(pb * Load<Doubles>(t.PerSquared[0]));
  const Doubles onAc = clamp(pc * Load<Doubles>(t.PerSquared[1]));
  const Doubles onBc = clamp((pc - pb + bb - bc) * Load<Doubles>(t.PerSquared[2]));
  const auto squaredTo = [&](Doubles x, Doubles y)
  {
    const Vectors<Doubles> away = p - ab * x - ac * y;
    return away.Dot(away);
  };
  const Doubles sides =
    Smaller(Smaller(squaredTo(onAb, zero), squaredTo(zero, onAc)), squaredTo(one - onBc, onBc));
  const DoubleMask inside = (b >= zero) & (c >= zero) & (b + c <= one) & (per > zero);
  return Select(inside, squaredTo(b, c), sides);
}

void ReachTriangles(const TriangleBatch* batches, int count, const double* point, double* squared)
{
  const Doubles zero = {};
  const Vectors<Doubles> p = { zero + point[0], zero + point[1], zero + point[2] };
  for (int i = 0; i < count; ++i)
  {
    Store(ReachFour(batches[i], p), squared + TriangleBatch::Size * i);
  }
}
}
}

#endif
