// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fragments.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/Statistics.h"

namespace bonedecimate
{
namespace
{
/// A closed fragment keeps at least this share of its volume: a flat one would be as good as gone.
constexpr double LeastVolumeShare = 0.25;
}

Fragments::Fragments(const HalfEdgeMesh& mesh, const Surface& surface)
{
  Components components = FindComponents(surface);
  this->OfVertex = std::move(components.OfPoint);
  this->Volumes.resize(static_cast<std::size_t>(components.Count));
  // About a point of its own, so that a small fragment far from the origin keeps its digits.
  std::vector<Index> anchor(this->Volumes.size(), None);
  for (const Triangle& c : surface.Triangles)
  {
    const Index fragment = this->OfVertex[c[0]];
    anchor[fragment] = anchor[fragment] == None ? c[0] : anchor[fragment];
    const Vector3& from = surface.Points[anchor[fragment]];
    const Vector3& corner = surface.Points[c[0]];
    this->Volumes[fragment].AtFirst +=
      AreaVector(corner, surface.Points[c[1]], surface.Points[c[2]]).dot(corner - from) / 3.0;
  }
  for (Volume& volume : this->Volumes)
  {
    volume.Now = volume.AtFirst;
  }
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Kind(v) != VertexKind::Inside)
    {
      this->Volumes[this->OfVertex[v]].IsClosed = false;
    }
  }
}

//------------------------------------------------------------------------------
bool Fragments::MayChange(Index v, double volumeChange, const Changes& pending, int workers) const
{
  const Volume& volume = this->Volumes[this->OfVertex[v]];
  if (!volume.IsClosed || volume.AtFirst == 0.0)
  {
    return true;
  }
  const double spare = (volume.Now / volume.AtFirst - LeastVolumeShare) / workers;
  const double change = volumeChange / volume.AtFirst;
  return change >= 0.0 || spare + pending.Of(this->OfVertex[v]) / volume.AtFirst + change >= 0.0;
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
