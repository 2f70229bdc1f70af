// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfEdgeMesh.h"

#include "Base/Parallel.h"
#include "EdgeMatching.h"
#include "EdgeNeighborhood.h"
#include "Edit.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The bits of the area in the word that also contains z of the initial normal: the upper half of a
/// positive float, so never None.
constexpr std::uint32_t AreaBits = 0xFFFF0000U;

/// Mean length of the first edge of each triangle, mm.
double MeanLength(const Surface& surface, int threads)
{
  const double sum = SumOverBlocks(surface.Triangles.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      double part = 0.0; // mm
      for (std::size_t f = first; f < last; ++f)
      {
        const Triangle& c = surface.Triangles[f];
        part += (surface.Points[c[1]] - surface.Points[c[0]]).norm();
      }
      return part;
    });
  const double mean = sum / static_cast<double>(surface.Triangles.size());
  return mean > 0.0 && std::isfinite(mean) ? mean : 1.0;
}
}

HalfEdgeMesh::HalfEdgeMesh(const Surface& surface, int threads, const PatchMap& patches)
{
  const EdgeMatching edges(surface.Triangles, surface.Points.size(), threads);
  *this = HalfEdgeMesh(surface, edges, edges.FindRings(), threads, patches);
}

//------------------------------------------------------------------------------
HalfEdgeMesh::HalfEdgeMesh(const Surface& surface, const EdgeMatching& edges, Rings rings,
  int threads, const PatchMap& patches)
  : Vertices(surface.Points.size())
  , Faces(surface.Triangles.size())
  , LiveFaces(static_cast<Index>(surface.Triangles.size()))
  , Length(MeanLength(surface, threads))
  , LengthUnit(std::ldexp(1.0, std::ilogb(this->Length)))
{
  this->Constraints = std::move(rings.Constraints);
  ForEachId(surface.Points.size(), threads,
    [&](std::size_t v) {
      this->Vertices[v] = { surface.Points[v], {}, rings.Outgoing[v] };
    });
  ForEachId(surface.Triangles.size(), threads,
    [&](std::size_t f)
    {
      const Triangle& c = surface.Triangles[f];
      const Index* twins = edges.Twins().data() + 4 * f;
      this->Faces[f].Origins = { c[0], c[1], c[2], None };
      this->Faces[f].Twins = { std::max(None, twins[0]), std::max(None, twins[1]),
        std::max(None, twins[2]), None }; // odd edges have no twin
    });
  if (patches.OriginalVertices.empty())
  {
    this->Counts = edges.CountEdges();
  }
  else
  {
    this->LinkDuplicates(patches);
  }
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::LinkDuplicates(const PatchMap& patches)
{
  this->Counts = patches.Edges;
  this->OriginalVertices = patches.OriginalVertices;
  this->NextDuplicates = patches.OriginalVertices;
  for (VertexId v = 0; v < this->NumberOfVertexSlots(); ++v)
  {
    const Index original = this->OriginalVertices[v];
    if (v != original)
    {
      this->NextDuplicates[v] = std::exchange(this->NextDuplicates[original], v);
    }
  }
  for (VertexId v = 0; v < this->NumberOfVertexSlots(); ++v)
  {
    VertexConstraint& kind = this->Constraints[v];
    const bool isAlone = this->NextDuplicates[v] == v;
    kind = isAlone                         ? kind
      : kind == VertexConstraint::Free     ? VertexConstraint::Stationary
      : kind == VertexConstraint::Boundary ? VertexConstraint::StationaryBoundary
                                           : kind;
  }
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Collapse(const EdgeNeighborhood& around, VertexId keep, const Vector3& position)
{
  const VertexId gone = around.Start == keep ? around.End : around.Start;
  for (const Index out : around.Corners)
  {
    this->Faces[Face(out)].Origins[out & 3] = keep;
  }
  const HalfEdgeId twin = this->Twin(around.Edge);
  this->RemoveFace(around.Edge);
  if (twin != None)
  {
    this->RemoveFace(twin);
  }
  this->Vertices[gone].Outgoing = None;
  this->Vertices[keep].Outgoing = around.Corners.front(); // on a boundary the one without a twin
  this->Constraints[keep] = std::max(this->Constraints[keep], this->Constraints[gone]);
  this->Vertices[keep].Position = position;
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::PackInitialNormal(FaceRecord& record, const Vector3& area)
{
  const double scale = 32767.0 / area.cwiseAbs().maxCoeff();
  const bool hasDirection = std::isfinite(scale) && area.allFinite();
  const auto pack = [&](Eigen::Index k)
  {
    const double part = hasDirection ? scale * area[k] : 0.0;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(part)) & 0xFFFFU;
  };
  record.Origins[3] = static_cast<Index>(pack(0) << 16U | pack(1));
  const float size = static_cast<float>(area.norm());
  std::uint32_t bits = 0;
  std::memcpy(&bits, &size, sizeof(bits));
  record.Twins[3] = static_cast<Index>((bits & AreaBits) | pack(2));
}

//------------------------------------------------------------------------------
double HalfEdgeMesh::InitialArea(FaceId face) const
{
  const std::uint32_t bits = static_cast<std::uint32_t>(this->Faces[face].Twins[3]) & AreaBits;
  float size = 0.0F;
  std::memcpy(&size, &bits, sizeof(size));
  return static_cast<double>(size);
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Pair(HalfEdgeId h, HalfEdgeId twin)
{
  this->Faces[h >> 2].Twins[h & 3] = twin;
  if (twin != None)
  {
    this->Faces[twin >> 2].Twins[twin & 3] = h;
  }
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Save(FaceId face, Saved& saved) const
{
  saved.Faces.emplace_back(face, this->Faces[face]);
  for (Index corner = 0; corner < 3; ++corner)
  {
    const HalfEdgeId h = HalfEdge(face, corner);
    saved.Vertices.emplace_back(this->Origin(h), this->Vertices[this->Origin(h)]);
    if (this->Twin(h) != None)
    {
      saved.Faces.emplace_back(Face(this->Twin(h)), this->Faces[Face(this->Twin(h))]);
    }
  }
}

//------------------------------------------------------------------------------
/// Restores in reverse order, so that of records saved twice, the first copy remains.
void HalfEdgeMesh::Restore(const Saved& saved)
{
  std::for_each(saved.Faces.rbegin(), saved.Faces.rend(),
    [this](const auto& face) { this->Faces[face.first] = face.second; });
  std::for_each(saved.Vertices.rbegin(), saved.Vertices.rend(),
    [this](const auto& vertex) { this->Vertices[vertex.first] = vertex.second; });
}

//------------------------------------------------------------------------------
/// Replaces faces a b c and b a d by a d c and b c d, each in its old slot.
void HalfEdgeMesh::Flip(HalfEdgeId h)
{
  const HalfEdgeId t = this->Twin(h);
  const std::array<Index, 3> f = { h, Next(h), Previous(h) };
  const std::array<Index, 3> g = { t, Next(t), Previous(t) };
  const std::array<Index, 4> outer = { this->Twin(f[1]), this->Twin(f[2]), this->Twin(g[1]),
    this->Twin(g[2]) }; // across b c, c a, a d, d b
  const VertexId a = this->Origin(h);
  const VertexId b = this->Origin(t);
  const VertexId c = this->Origin(f[2]);
  const VertexId d = this->Origin(g[2]);
  const auto turn = [this](VertexId v, Index from, Index other, Index to)
  {
    Index& outgoing = this->Vertices[v].Outgoing;
    outgoing = outgoing == from || outgoing == other ? to : outgoing;
  };
  turn(a, h, g[1], f[2]);
  turn(b, t, f[1], g[2]);
  turn(c, f[2], None, f[1]);
  turn(d, g[2], None, g[1]);
  const auto setOrigin = [this](Index half, VertexId v)
  { this->Faces[half >> 2].Origins[half & 3] = v; };
  setOrigin(f[0], d);
  setOrigin(f[1], c);
  setOrigin(f[2], a);
  setOrigin(g[0], c);
  setOrigin(g[1], d);
  setOrigin(g[2], b);
  this->Pair(f[1], outer[1]);
  this->Pair(f[2], outer[2]);
  this->Pair(g[1], outer[3]);
  this->Pair(g[2], outer[0]);
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::SplitFace(HalfEdgeId h, VertexId vertex, FaceId made)
{
  const HalfEdgeId next = Next(h);
  const HalfEdgeId outer = this->Twin(next);
  const VertexId b = this->Origin(next);
  const FaceRecord& old = this->Faces[Face(h)];
  FaceRecord& record = this->Faces[made];
  record = { { vertex, b, this->Apex(h), old.Origins[3] }, { None, None, None, old.Twins[3] } };
  this->Faces[next >> 2].Origins[next & 3] = vertex;
  this->Pair(HalfEdge(made, 1), outer);
  this->Pair(HalfEdge(made, 2), next);
  if (this->Outgoing(b) == next)
  {
    this->Vertices[b].Outgoing = HalfEdge(made, 1);
  }
  this->InputFaces[made] = this->InputFaces[Face(h)];
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Split(const Edit& edit)
{
  if (this->InputFaces.empty())
  {
    this->InputFaces.resize(this->Faces.size());
    std::iota(this->InputFaces.begin(), this->InputFaces.end(), 0);
  }
  const HalfEdgeId h = edit.Edge;
  const HalfEdgeId t = this->Twin(h);
  const VertexId m = edit.Keep;
  this->Vertices[m].Position = edit.Position;
  this->SplitFace(h, m, edit.Made[0]);
  const HalfEdgeId rest = HalfEdge(edit.Made[0], 0); // from m to b
  if (t != None)
  {
    this->SplitFace(t, m, edit.Made[1]);
    this->Pair(h, HalfEdge(edit.Made[1], 0)); // from m to a
    this->Pair(t, rest);
  }
  this->Vertices[m].Outgoing = rest; // on a boundary the one without a twin
  this->Constraints[m] = t != None ? VertexConstraint::Free : VertexConstraint::Boundary;
}

//------------------------------------------------------------------------------
/// Removes the face of h and merges its other two edges. Its initial normal stays, in case the edit
/// is undone.
void HalfEdgeMesh::RemoveFace(HalfEdgeId h)
{
  const HalfEdgeId alongNext = this->Twin(Next(h));
  const HalfEdgeId alongPrevious = this->Twin(Previous(h));
  if (alongNext != None)
  {
    this->Faces[Face(alongNext)].Twins[alongNext & 3] = alongPrevious;
  }
  if (alongPrevious != None)
  {
    this->Faces[Face(alongPrevious)].Twins[alongPrevious & 3] = alongNext;
  }
  const VertexId apex = this->Apex(h);
  if (this->Outgoing(apex) == Previous(h))
  {
    this->Vertices[apex].Outgoing = alongNext;
  }
  FaceRecord& record = this->Faces[Face(h)];
  record = { { None, None, None, record.Origins[3] }, { None, None, None, record.Twins[3] } };
}
}
