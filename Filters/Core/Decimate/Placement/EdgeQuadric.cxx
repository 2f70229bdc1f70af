// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeQuadric.h"

namespace bonedecimate
{
namespace
{
SymmetricFloat3 MatrixOf(const RingQuadric& q)
{
  return { q.M[0], q.M[1], q.M[2], q.M[3], q.M[4], q.M[5] };
}

Float3 VectorOf(const RingQuadric& q)
{
  return { q.G[0], q.G[1], q.G[2] };
}

SymmetricFloat3 Sum(const SymmetricFloat3& a, const SymmetricFloat3& b)
{
  return { a.XX + b.XX, a.XY + b.XY, a.XZ + b.XZ, a.YY + b.YY, a.YZ + b.YZ, a.ZZ + b.ZZ };
}

SymmetricFloat3 Difference(const SymmetricFloat3& a, const SymmetricFloat3& b)
{
  return { a.XX - b.XX, a.XY - b.XY, a.XZ - b.XZ, a.YY - b.YY, a.YZ - b.YZ, a.ZZ - b.ZZ };
}
}

EdgeQuadric QuadricOfEdge(const VertexRecord& first, const VertexRecord& second, double perUnit)
{
  const double scale = 0.5 * perUnit;
  const auto half = [&](int k)
  { return static_cast<float>((second.Position[k] - first.Position[k]) * scale); };
  const SymmetricFloat3 firstM = MatrixOf(first.Quadric);
  const SymmetricFloat3 secondM = MatrixOf(second.Quadric);
  const Float3 firstG = VectorOf(first.Quadric);
  const Float3 secondG = VectorOf(second.Quadric);
  EdgeQuadric q;
  q.Half = { half(0), half(1), half(2) };
  q.M = Sum(firstM, secondM);
  q.R = Difference(secondM, firstM) * q.Half;
  q.G = firstG + secondG;
  q.D = (secondG - firstG).Dot(q.Half);
  return q;
}
}
