// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampledErrors.h"

#include "Base/Parallel.h"

namespace bonedecimate
{
SampledErrors::SampledErrors(
  const HalfEdgeMesh& mesh, const Samples& samples, const OriginalHints& hints)
  : Mesh(mesh)
  , OriginalSamples(samples)
  , Hints(hints)
  , Penalties(mesh.Unit(), samples.MeanValues())
  , FaceErrors(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), 0.0F)
  , VertexErrors(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0.0F)
  , Stamps(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
double SampledErrors::OfFace(FaceId face) const
{
  return ErrorOfFace(this->OriginalSamples, this->Penalties, face, FrameOf(this->Mesh, face));
}

//------------------------------------------------------------------------------
double SampledErrors::OfVertex(VertexId vertex) const
{
  double area = 0.0; // mm^2
  for (const HalfEdgeId h : this->Mesh.OutgoingOf(vertex))
  {
    area += FrameOf(this->Mesh, HalfEdgeMesh::Face(h)).SurfaceArea();
  }
  const PointOnMesh found = this->Hints.Find(this->Mesh.Position(vertex), vertex);
  return this->Penalties.OfVertex(
    BackWeightOfCollapse * CornerFraction * this->Penalties.InUnits(area),
    found.Point.SquaredDistance);
}

//------------------------------------------------------------------------------
bool SampledErrors::MeasureAll(int threads, const Monitor& monitor)
{
  const auto ofFaces = [&](std::size_t, std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const FaceId face = static_cast<Index>(i);
      this->FaceErrors[i] =
        this->Mesh.IsAlive(face) ? static_cast<float>(this->OfFace(face)) : 0.0F;
    }
  };
  const auto ofVertices = [&](std::size_t, std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const VertexId v = static_cast<Index>(i);
      const bool counts = this->Mesh.Outgoing(v) != None && this->Mesh.MovesFreely(v);
      this->VertexErrors[i] = counts ? static_cast<float>(this->OfVertex(v)) : 0.0F;
    }
  };
  return ForEachChunk(this->FaceErrors.size(), threads, PartOf(monitor, 0.0, 0.7), ofFaces) &&
    ForEachChunk(this->VertexErrors.size(), threads, PartOf(monitor, 0.7, 1.0), ofVertices);
}

//------------------------------------------------------------------------------
double SampledErrors::ErrorAround(const EdgeNeighborhood& around) const
{
  double error = this->VertexErrors[around.Start] + this->VertexErrors[around.End] +
    this->FaceErrors[around.RemovedFaces[0]] + this->FaceErrors[around.RemovedFaces[1]];
  for (const Index corner : around.Corners)
  {
    error += this->FaceErrors[HalfEdgeMesh::Face(corner)];
  }
  return error;
}

//------------------------------------------------------------------------------
void SampledErrors::AfterCollapse(VertexId vertex, double vertexError)
{
  this->VertexErrors[vertex] = static_cast<float>(vertexError);
  ++this->Stamps[vertex];
  for (const HalfEdgeId h : this->Mesh.OutgoingOf(vertex))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    this->FaceErrors[face] = static_cast<float>(this->OfFace(face));
    ++this->Stamps[this->Mesh.Target(h)];
  }
}
}
