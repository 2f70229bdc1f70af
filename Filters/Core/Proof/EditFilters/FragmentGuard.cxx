// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FragmentGuard.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/Statistics.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// A closed fragment keeps at least this part of its volume.
constexpr double MinVolumeRatio = 0.25;
/// Edits of a vertex in a pass: its own move, flips of its edges, about three a vertex, and a
/// margin.
constexpr double EditsOfVertex = 8.0;
}

FragmentGuard::FragmentGuard(
  const HalfEdgeMesh& mesh, const Surface& surface, const std::vector<Index>& originals)
{
  Components components = FindComponents(surface, originals);
  this->ComponentOfVertex = std::move(components.OfPoint);
  this->Volumes.resize(static_cast<std::size_t>(components.Count));
  const std::vector<double> volumes = this->Measure(mesh);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    this->Volumes[i].Initial = volumes[i];
    this->Volumes[i].Current = volumes[i];
  }
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (!mesh.MovesFreely(v))
    {
      this->Volumes[this->ComponentOfVertex[v]].IsClosed = false;
    }
  }
}

/// mm^3. Each volume is relative to a point of its component, so that a small fragment far from the
/// origin keeps its digits.
std::vector<double> FragmentGuard::Measure(const HalfEdgeMesh& mesh) const
{
  std::vector<double> volumes(this->Volumes.size(), 0.0);
  std::vector<Index> anchor(this->Volumes.size(), None);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const Triangle c = mesh.Corners(face);
    const Index fragment = this->ComponentOfVertex[c[0]];
    anchor[fragment] = anchor[fragment] == None ? c[0] : anchor[fragment];
    const Vector3& corner = mesh.Position(c[0]);
    volumes[fragment] += Dot(AreaVector(corner, mesh.Position(c[1]), mesh.Position(c[2])),
                           corner - mesh.Position(anchor[fragment])) /
      3.0;
  }
  return volumes;
}

//------------------------------------------------------------------------------
std::vector<char> FragmentGuard::FindTooSmall(const HalfEdgeMesh& mesh) const
{
  const std::vector<double> volumes = this->Measure(mesh);
  std::vector<char> isTooSmall(volumes.size(), 0);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const Volume& volume = this->Volumes[i];
    isTooSmall[i] =
      volume.IsClosed && volume.Initial != 0.0 && volumes[i] / volume.Initial < MinVolumeRatio ? 1
                                                                                               : 0;
  }
  return isTooSmall;
}

//------------------------------------------------------------------------------
void FragmentGuard::DistributeBudget(const HalfEdgeMesh& mesh)
{
  std::vector<Index> vertices(this->Volumes.size(), 0);
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    vertices[this->ComponentOfVertex[v]] += mesh.Outgoing(v) != None ? 1 : 0;
  }
  const std::vector<double> volumes = this->Measure(mesh);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    Volume& volume = this->Volumes[i];
    volume.Current = volumes[i];
    const double left = std::abs(volume.Current) - MinVolumeRatio * std::abs(volume.Initial);
    volume.Budget = std::max(0.0, left) / (EditsOfVertex * std::max(1, vertices[i]));
  }
}

//------------------------------------------------------------------------------
bool FragmentGuard::BudgetAllows(const SurfaceChange& change) const
{
  const Volume& volume = this->Volumes[this->ComponentOfVertex[change.Vertex]];
  const double gain = volume.Initial < 0.0 ? -change.VolumeChange : change.VolumeChange;
  return !volume.IsClosed || volume.Initial == 0.0 || gain >= -volume.Budget;
}

//------------------------------------------------------------------------------
/// Divides what may still be lost among workers that do not know each other's changes.
bool FragmentGuard::MayChange(const SurfaceChange& change, int workers) const
{
  const Index component = this->ComponentOfVertex[change.Vertex];
  const Volume& volume = this->Volumes[component];
  if (!volume.IsClosed || volume.Initial == 0.0)
  {
    return true;
  }
  const double gain = change.VolumeChange / volume.Initial;
  if (gain >= 0.0)
  {
    return true;
  }
  const double spare = (volume.Current / volume.Initial - MinVolumeRatio) / workers;
  return spare + change.Unsettled->Of(component) / volume.Initial + gain >= 0.0;
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> FragmentGuard::MakePending()
{
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
/// The budgets of the vertices are half of what flips and moves may remove.
Decision FragmentGuard::Screen(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  const bool isCollapse = change.Requested.Kind == EditKind::Collapse;
  const bool exceeds = isCollapse || !this->BudgetAllows(change);
  static_cast<Pending&>(pending).ExceedsBudget = exceeds;
  const int workers = isCollapse ? change.Workers : 2 * change.Workers;
  return exceeds && !this->MayChange(change, workers) ? Rejection::Fragment
                                                      : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
bool FragmentGuard::StillAccepts(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  return this->Screen(mesh, change, pending).IsAccepted();
}

//------------------------------------------------------------------------------
void FragmentGuard::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally& tally)
{
  if (static_cast<Pending&>(pending).ExceedsBudget)
  {
    tally.Volumes.Add(this->ComponentOfVertex[change.Vertex], change.VolumeChange);
  }
}

//------------------------------------------------------------------------------
void FragmentGuard::Settle(Tally* tallies, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const FragmentVolumes::Change& settled : tallies[i].Volumes.Changes())
    {
      this->Volumes[settled.Component].Current += settled.Volume;
    }
    tallies[i].Volumes.Clear();
  }
}
}
