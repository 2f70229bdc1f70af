// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Guarantee.h"

#include "Mesh/SurfaceAssembly.h"
#include "Prover.h"

namespace bonedecimate
{
Vector3 Promise::Rounded(const Vector3& position) const
{
  return this->RoundsToSingle ? Vector3(RoundedToSingle(position + this->Origin) - this->Origin)
                              : position;
}

//------------------------------------------------------------------------------
Guarantee::Guarantee(const HalfEdgeMesh& atFirst, const BoundingTree& tree, const Promise& promise)
  : Source(atFirst)
  , Tree(tree)
  , Promised(promise)
  , Allowed(atFirst, promise)
  , ByFaces(atFirst.NumberOfFaceSlots(), atFirst.NumberOfFaceSlots())
  , Borders(atFirst)
  , ByBorders(this->Borders.Count(),
      this->Borders.Count() == 0 ? 0 : HalfEdgeMesh::HalfEdge(atFirst.NumberOfFaceSlots(), 0))
  , NearestBorder(this->Borders.EdgesAtVertices())
  , Nearest(static_cast<std::size_t>(atFirst.NumberOfVertexSlots()), None)
  , Witnesses(this->Nearest.size(), { None, None, None, None })
{
  for (Index face = 0; face < atFirst.NumberOfFaceSlots(); ++face)
  {
    this->ByFaces.Add(face, face);
    for (const Index v : atFirst.Corners(face))
    {
      const Index known = this->Nearest[v];
      const bool allowsMore =
        known == None || this->Allowed.Over(face) >= this->Allowed.Over(known);
      this->Nearest[v] = allowsMore ? face : known;
    }
  }
  for (Index edge = 0; edge < this->Borders.Count(); ++edge)
  {
    this->ByBorders.Add(edge, this->Borders.HalfEdge(edge));
  }
}

Guarantee::~Guarantee() = default;

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
