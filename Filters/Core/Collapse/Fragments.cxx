// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fragments.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/Statistics.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// A closed fragment keeps at least this share of its volume: a flat one would be as good as gone.
constexpr double LeastVolumeShare = 0.25;
/// A vertex is edited by its own move and by flips of its edges: about three edges a vertex, with room to spare.
constexpr double EditsOfVertex = 8.0;
}

Fragments::Fragments(const HalfEdgeMesh& mesh, const Surface& joined)
{
  Components components = FindComponents(joined);
  this->OfVertex = std::move(components.OfPoint);
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    this->OfVertex[v] = this->OfVertex[mesh.Site(v)];
  }
  this->Volumes.resize(static_cast<std::size_t>(components.Count));
  const std::vector<double> volumes = this->Measure(mesh);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    this->Volumes[i].AtFirst = volumes[i];
    this->Volumes[i].Now = volumes[i];
  }
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Kind(v) != VertexKind::Inside)
    {
      this->Volumes[this->OfVertex[v]].IsClosed = false;
    }
  }
}

/// Each about a point of its own, so that a small fragment far from the origin keeps its digits. mm^3
std::vector<double> Fragments::Measure(const HalfEdgeMesh& mesh) const
{
  std::vector<double> volumes(this->Volumes.size(), 0.0);
  std::vector<Index> anchor(this->Volumes.size(), None);
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const Triangle c = mesh.Corners(face);
    const Index fragment = this->OfVertex[c[0]];
    anchor[fragment] = anchor[fragment] == None ? c[0] : anchor[fragment];
    const Vector3& corner = mesh.Position(c[0]);
    volumes[fragment] += AreaVector(corner, mesh.Position(c[1]), mesh.Position(c[2]))
                           .dot(corner - mesh.Position(anchor[fragment])) /
      3.0;
  }
  return volumes;
}

//------------------------------------------------------------------------------
void Fragments::Share(const HalfEdgeMesh& mesh)
{
  std::vector<Index> vertices(this->Volumes.size(), 0);
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    vertices[this->OfVertex[v]] += mesh.Outgoing(v) != None ? 1 : 0;
  }
  const std::vector<double> volumes = this->Measure(mesh);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    Volume& volume = this->Volumes[i];
    volume.Now = volumes[i];
    const double left = std::abs(volume.Now) - LeastVolumeShare * std::abs(volume.AtFirst);
    volume.Share = std::max(0.0, left) / (EditsOfVertex * std::max(1, vertices[i]));
  }
}

//------------------------------------------------------------------------------
bool Fragments::ShareAllows(Index v, double volumeChange) const
{
  const Volume& volume = this->Volumes[this->OfVertex[v]];
  const double gain = volume.AtFirst < 0.0 ? -volumeChange : volumeChange;
  return !volume.IsClosed || volume.AtFirst == 0.0 || gain >= -volume.Share;
}

//------------------------------------------------------------------------------
bool Fragments::MayChange(Index v, double volumeChange, const Changes& pending, int workers) const
{
  const Volume& volume = this->Volumes[this->OfVertex[v]];
  if (!volume.IsClosed || volume.AtFirst == 0.0)
  {
    return true;
  }
  const double change = volumeChange / volume.AtFirst;
  if (change >= 0.0)
  {
    return true;
  }
  const double spare = (volume.Now / volume.AtFirst - LeastVolumeShare) / workers;
  return spare + pending.Of(this->OfVertex[v]) / volume.AtFirst + change >= 0.0;
}

//------------------------------------------------------------------------------
void Fragments::Settle(Changes& changes)
{
  for (const Changes::Change& change : changes.List)
  {
    this->Volumes[change.Component].Now += change.Volume;
  }
  changes.List.clear();
}

//------------------------------------------------------------------------------
double Fragments::Changes::Of(Index component) const
{
  for (const Change& change : this->List)
  {
    if (change.Component == component)
    {
      return change.Volume;
    }
  }
  return 0.0;
}

//------------------------------------------------------------------------------
void Fragments::Changes::Add(Index component, double change)
{
  for (Change& known : this->List)
  {
    if (known.Component == component)
    {
      known.Volume += change;
      return;
    }
  }
  this->List.push_back({ component, change });
}
}
