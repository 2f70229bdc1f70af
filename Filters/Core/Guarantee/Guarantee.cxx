// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Guarantee.h"

#include "Prover.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// For the rounding of distances and of points between others, far more than they need.
constexpr double RelativeSlack = 1e-6;
/// Of the largest coordinate, for the same.
constexpr double AbsoluteSlack = 1e-14;

double RoundedToSingle(double coordinate, double origin)
{
  return static_cast<double>(static_cast<float>(coordinate + origin)) - origin;
}
}

Guarantee::Guarantee(const HalfEdgeMesh& atFirst, const BoundingTree& tree, const Promise& promise)
  : Source(atFirst)
  , Tree(tree)
  , Promised(promise)
  , ByFaces(atFirst.NumberOfFaceSlots(), atFirst.NumberOfFaceSlots())
  , Borders(atFirst)
  , ByBorders(this->Borders.Count(),
      this->Borders.Count() == 0 ? 0 : HalfEdgeMesh::HalfEdge(atFirst.NumberOfFaceSlots(), 0))
  , NearestBorder(this->Borders.EdgesAtVertices())
  , Nearest(static_cast<std::size_t>(atFirst.NumberOfVertexSlots()), None)
  , Witnesses(this->Nearest)
{
  double size = 0.0;     // mm
  double rounding = 0.0; // mm, by which points that never move are moved when they are written
  for (Index v = 0; v < atFirst.NumberOfVertexSlots(); ++v)
  {
    const Vector3& p = atFirst.Position(v);
    size = std::max(size, (p + promise.Origin).cwiseAbs().maxCoeff());
    rounding = std::max(rounding, (this->Rounded(p) - p).norm());
  }
  this->Limit = promise.Error * (1.0 - RelativeSlack) - AbsoluteSlack * size - rounding;
  for (Index face = 0; face < atFirst.NumberOfFaceSlots(); ++face)
  {
    this->ByFaces.Add(face, face);
    for (const Index v : atFirst.Corners(face))
    {
      this->Nearest[v] = face;
    }
  }
  for (Index edge = 0; edge < this->Borders.Count(); ++edge)
  {
    this->ByBorders.Add(edge, this->Borders.HalfEdge(edge));
  }
}

Guarantee::~Guarantee() = default;

//------------------------------------------------------------------------------
Vector3 Guarantee::Rounded(const Vector3& position) const
{
  const Vector3& origin = this->Promised.Origin;
  return this->Promised.RoundsToSingle
    ? Vector3(RoundedToSingle(position[0], origin[0]), RoundedToSingle(position[1], origin[1]),
        RoundedToSingle(position[2], origin[2]))
    : position;
}

//------------------------------------------------------------------------------
std::shared_ptr<Prover> Guarantee::Lend()
{
  std::unique_ptr<Prover> prover;
  {
    const std::lock_guard<std::mutex> lock(this->Lending);
    if (!this->Idle.empty())
    {
      prover = std::move(this->Idle.back());
      this->Idle.pop_back();
    }
  }
  if (!prover)
  {
    prover = std::make_unique<Prover>(*this);
  }
  return { prover.release(),
    [this](Prover* returned)
    {
      const std::lock_guard<std::mutex> lock(this->Lending);
      this->Idle.emplace_back(returned);
    } };
}
}
