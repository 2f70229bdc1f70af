// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePreserving.h"

namespace bonedecimate
{
namespace
{
/// Determinant times the inverse.
SymmetricFloat3 Adjugate(const SymmetricFloat3& m)
{
  return { m.YY * m.ZZ - m.YZ * m.YZ, m.XZ * m.YZ - m.XY * m.ZZ, m.XY * m.YZ - m.XZ * m.YY,
    m.XX * m.ZZ - m.XZ * m.XZ, m.XY * m.XZ - m.XX * m.YZ, m.XX * m.YY - m.XY * m.XY };
}

float Determinant(const SymmetricFloat3& m, const SymmetricFloat3& adjugate)
{
  return m.XX * adjugate.XX + m.XY * adjugate.XY + m.XZ * adjugate.XZ;
}

Float3 PositionInSpace(const EdgeQuadric& q)
{
  const float ridge = q.M.Trace() * (QuadricRidge / 3.0F);
  const SymmetricFloat3 m = { q.M.XX + ridge, q.M.XY, q.M.XZ, q.M.YY + ridge, q.M.YZ,
    q.M.ZZ + ridge };
  const SymmetricFloat3 adjugate = Adjugate(m);
  const float perDeterminant = 1.0F / Determinant(m, adjugate);
  const Float3 leastSquares = (adjugate * q.R) * perDeterminant;
  const Float3 y = (adjugate * q.G) * perDeterminant;
  const Float3 volumeKept = leastSquares + y * ((q.D - q.G.Dot(leastSquares)) / q.G.Dot(y));
  const float farthest = q.Half.Dot(q.Half) * FarthestMoveSquared;
  // Comparisons with NaN are false.
  if (volumeKept.Dot(volumeKept) <= farthest)
  {
    return volumeKept;
  }
  return leastSquares.Dot(leastSquares) <= farthest ? leastSquares : Float3{ 0.0F, 0.0F, 0.0F };
}

Float3 PositionOnEdge(const EdgeQuadric& q)
{
  const float curvature = q.Half.Dot(q.M * q.Half);
  float t = q.R.Dot(q.Half) / curvature;
  t = t < 1.0F ? t : 1.0F;
  t = t > -1.0F ? t : -1.0F;
  return q.Half * (curvature > 0.0F ? t : 0.0F);
}
}

Float3 VolumePreservingPosition(const EdgeQuadric& quadric, Freedom freedom)
{
  switch (freedom)
  {
    case Freedom::Edge:
      return PositionOnEdge(quadric);
    case Freedom::First:
      return quadric.Half * -1.0F;
    case Freedom::Second:
      return quadric.Half;
    default:
      return PositionInSpace(quadric);
  }
}
}
